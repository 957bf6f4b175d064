"""The version of the package: that of the project, in build/Version.props."""

__version__ = "0.1.0"
