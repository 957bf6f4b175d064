using Harvester.Capture.Harvesting;

namespace Harvester.Capture.Storage;

/// <summary>What session.json says.</summary>
/// <param name="Origin">Where the session comes from.</param>
/// <param name="Start">How it began.</param>
/// <param name="End">How it ended; null while it is recorded, and for ever when the recording was cut off.</param>
/// <param name="FramesWritten">Frames of the session, those before a continuation included.</param>
internal sealed record SessionRecord(SessionOrigin Origin, SessionStart Start, SessionEnd? End, int FramesWritten);
