"""Numbers in a configuration's text: read by name, and replaced where they stand,
so that comments, order and anchors stay as they are."""

import yaml


class ConfigError(Exception):
    """The message names the file, the parameter and what is expected."""


class ConfigText:
    """The YAML text of a configuration.

    A name is its sections and its own with dots between them, such as
    navigator.vfh.speed. What stands under an alias is found at its anchor.
    """

    def __init__(self, file, text=None):
        """Reads the file where its text is not given; raises ConfigError."""
        self.file = file
        try:
            if text is None:
                with open(file) as stream:
                    text = stream.read()
            self._root = yaml.compose(text, Loader=yaml.SafeLoader)
        except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
            raise ConfigError("{}: {}".format(file, error)) from error
        self.text = text

    def _scalar(self, name):
        node = self._root
        for depth, key in enumerate(name.split("."), 1):
            entries = node.value if isinstance(node, yaml.MappingNode) else ()
            node = next((value for own, value in entries if own.value == key),
                        None)
            if node is None:
                raise ConfigError("{}: there is no {}, which the search space "
                                  "names".format(self.file, ".".join(
                                      name.split(".")[:depth])))
        return node

    def number(self, name):
        """int or float, as it is written. Raises ConfigError."""
        node = self._scalar(name)
        # A number in quotes is a text, and stays one.
        value = (yaml.safe_load(node.value)
                 if isinstance(node, yaml.ScalarNode) and not node.style
                 else None)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise ConfigError("{}: {} is {!r}; expected a number".format(
                self.file, name, getattr(node, "value", None)
                if isinstance(node, yaml.ScalarNode) else "a section"))
        return value

    def place(self, name):
        """First and last index of the number in the text: the same for two
        names of one value."""
        node = self._scalar(name)
        end = node.end_mark.index
        # The mark of a value's begin is its anchor's, where it has one.
        begin = end - len(node.value)
        assert self.text[begin:end] == node.value
        return begin, end

    def with_numbers(self, values):
        """The text with other numbers; values: {name: int or float}."""
        text = self.text
        places = {self.place(name): value for name, value in values.items()}
        for (begin, end), value in sorted(places.items(), reverse=True):
            text = text[:begin] + number_text(value) + text[end:]
        return text


def number_text(value):
    """As every YAML reads it: 1e-05 is a string to some."""
    text = repr(value)
    if "e" in text and "." not in text:
        text = text.replace("e", ".0e")
    return text
