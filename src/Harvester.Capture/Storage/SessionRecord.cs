using Harvester.Capture.Harvesting;

namespace Harvester.Capture.Storage;

/// <summary>What session.json says.</summary>
/// <param name="Origin">Where the session comes from.</param>
/// <param name="Start">How it began.</param>
/// <param name="End">How it ended; null while it is being recorded, and if the recording was cut off.</param>
/// <param name="FramesWritten">Frames of the session, including those of earlier runs.</param>
/// <param name="HasManifest">Whether the session has a manifest; one of an earlier version that was resumed has none.</param>
internal sealed record SessionRecord(SessionOrigin Origin, SessionStart Start, SessionEnd? End, int FramesWritten, bool HasManifest);
