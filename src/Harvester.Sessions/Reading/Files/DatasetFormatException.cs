namespace Harvester.Sessions.Reading.Files;

/// <summary>A file does not follow its format. The message says where, and what was expected.</summary>
public sealed class DatasetFormatException : Exception
{
    /// <summary>Creates the exception with a message for the user.</summary>
    public DatasetFormatException(string message)
        : base(message) { }

    /// <summary>Creates the exception with a message for the user and its cause.</summary>
    public DatasetFormatException(string message, Exception innerException)
        : base(message, innerException) { }
}
