using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>What the radars detected at a moment; part of its first view.</summary>
/// <param name="scans">One scan of each radar, in the order of the rig.</param>
public sealed class RadarPart(IReadOnlyList<RadarScan> scans) : FramePart
{
    /// <inheritdoc />
    protected override IReadOnlyList<FileContent> Contents => [];

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key) => new RadarsLabel(scans);
}
