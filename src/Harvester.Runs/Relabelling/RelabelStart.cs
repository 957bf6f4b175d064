using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;

namespace Harvester.Runs.Relabelling;

/// <summary>What the first frame of a session decides for all its frames.</summary>
/// <param name="Labeller">Labels the frames.</param>
/// <param name="Options">The options as the new session states them: what cannot be kept is off.</param>
public sealed record RelabelStart(FrameRelabeller Labeller, HarvestOptions Options);
