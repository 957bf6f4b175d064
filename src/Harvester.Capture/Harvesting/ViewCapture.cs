using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>What is needed to take one view of a rig.</summary>
/// <param name="View">The view.</param>
/// <param name="Mount">The camera's pose in the frame of the vehicle's model.</param>
/// <param name="Labeller">Labels its images.</param>
/// <param name="Pool">Buffers of its image size.</param>
internal sealed record ViewCapture(RigView View, Pose Mount, FrameLabeller Labeller, PixelBufferPool Pool)
{
    /// <summary>Tolerance of the field of view: a game keeps it in single precision.</summary>
    public const double FovToleranceDegrees = 1e-3;

    /// <summary>Why the latest picture must not be used; null if it can be.</summary>
    public string? Refusal { get; set; }
}
