using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Labelling;

/// <summary>What the names of a frame's files are made of.</summary>
/// <param name="Frame">Number of the frame.</param>
/// <param name="View">The view of a rig; null without a rig.</param>
/// <param name="Format">The format of the session's images.</param>
public readonly record struct FrameKey(int Frame, string? View, ImageFormat Format);
