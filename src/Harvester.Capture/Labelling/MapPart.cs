using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>The map of a channel that has one map of colours for each frame.</summary>
/// <param name="channel">The channel.</param>
/// <param name="map">The map.</param>
/// <param name="method">Where its values come from.</param>
/// <param name="raysCast">The rays cast for it alone.</param>
public sealed class MapPart(MapChannel channel, PixelBuffer map, SemanticsMethod method, int raysCast) : FramePart
{
    /// <summary>The channel.</summary>
    public MapChannel Channel => channel;

    /// <summary>The map.</summary>
    public PixelBuffer Map => map;

    /// <inheritdoc />
    protected override IReadOnlyList<FileContent> Contents => [(stream, png) => png.Write(map, stream)];

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key) => new MapLabel(channel.Key, channel.PathOf(key.Frame, key.View), method, raysCast);
}
