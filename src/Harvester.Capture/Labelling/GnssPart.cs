using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>What the satellite receiver reported since the frame before; part of a moment's first view.</summary>
/// <param name="samples">The samples, in ascending order of time.</param>
public sealed class GnssPart(IReadOnlyList<GnssSample> samples) : FramePart
{
    /// <inheritdoc />
    protected override IReadOnlyList<FileContent> Contents => [];

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key) => new GnssLabel(samples);
}
