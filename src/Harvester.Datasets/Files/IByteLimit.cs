using System;

namespace Harvester.Datasets.Files;

/// <summary>Looks at the bytes of a file as they are read and refuses what its reader would have to hold whole.</summary>
internal interface IByteLimit
{
    /// <summary>Takes the next bytes.</summary>
    /// <exception cref="DatasetFormatException">A part of the file is too long.</exception>
    void Pass(ReadOnlySpan<byte> bytes);
}
