namespace Harvester.Play.Tapes;

/// <summary>What is recorded, and for how long.</summary>
/// <param name="Choice">What is recorded.</param>
/// <param name="Minutes">Time limit.</param>
/// <param name="Folder">The folder of the file.</param>
public sealed record TapeOptions(TapeChoice Choice, double Minutes, string Folder)
{
    /// <summary>Size of the file at which the recording ends, bytes. A minute without pictures takes a tenth at most.</summary>
    public long MaxFileBytes { get; init; } = 200_000_000;

    /// <summary>Size of the unpacked entries at which the recording ends, bytes: less than a reader accepts.</summary>
    public long MaxUnpackedBytes { get; init; } = TapeFormat.MaxUnpackedBytes / 2;
}
