namespace Harvester.Sessions.Reading.Files;

/// <summary>Checks the bytes of a file as they are read, and rejects parts that its reader would have to hold in memory.</summary>
internal interface IByteLimit
{
    /// <summary>Receives the next bytes.</summary>
    /// <exception cref="DatasetFormatException">A part of the file is too long.</exception>
    void Pass(ReadOnlySpan<byte> bytes);
}
