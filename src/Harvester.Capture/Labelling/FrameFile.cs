namespace Harvester.Capture.Labelling;

/// <summary>A file of a frame that is not its image.</summary>
/// <param name="Path">Its path within the session, with forward slashes.</param>
/// <param name="Content">Writes it.</param>
public sealed record FrameFile(string Path, FileContent Content);
