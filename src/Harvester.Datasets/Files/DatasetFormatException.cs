using System;

namespace Harvester.Datasets.Files;

/// <summary>A file's content is not what its format asks for. The message says where and what was expected.</summary>
public sealed class DatasetFormatException : Exception
{
    /// <summary>Makes the exception with a message for people.</summary>
    public DatasetFormatException(string message)
        : base(message)
    {
    }

    /// <summary>Makes the exception with a message for people and its cause.</summary>
    public DatasetFormatException(string message, Exception innerException)
        : base(message, innerException)
    {
    }
}
