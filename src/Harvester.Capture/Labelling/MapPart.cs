using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>The map of a channel that has one map for each frame.</summary>
public sealed class MapPart : FramePart
{
    private readonly SemanticsMethod _method;
    private readonly int _raysCast;

    /// <summary>A map of colours.</summary>
    /// <param name="channel">The channel, of 24 bits per pixel.</param>
    /// <param name="colours">The map.</param>
    /// <param name="method">Where its values come from.</param>
    /// <param name="raysCast">The rays cast for it alone.</param>
    public MapPart(MapChannel channel, PixelBuffer colours, SemanticsMethod method, int raysCast)
        : this(channel, (stream, png) => png.Write(colours, stream), method, raysCast) => Colours = colours;

    /// <summary>A map of numbers.</summary>
    /// <param name="channel">The channel, of 8 or 16 bits per pixel.</param>
    /// <param name="numbers">The map, with values up to 255 where the channel has 8 bits.</param>
    /// <param name="method">Where its values come from.</param>
    /// <param name="raysCast">The rays cast for it alone.</param>
    public MapPart(MapChannel channel, InstanceMap numbers, SemanticsMethod method, int raysCast)
        : this(channel, channel?.BitsPerPixel == 8 ? Grey8(numbers) : Grey16(numbers), method, raysCast) { }

    private MapPart(MapChannel channel, FileContent content, SemanticsMethod method, int raysCast)
    {
        Channel = channel;
        Contents = [content];
        _method = method;
        _raysCast = raysCast;
    }

    /// <summary>The channel.</summary>
    public MapChannel Channel { get; }

    /// <summary>The map of a channel of colours; null for numbers.</summary>
    public PixelBuffer? Colours { get; }

    /// <inheritdoc />
    protected override IReadOnlyList<FileContent> Contents { get; }

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key) =>
        new MapLabel(Channel.Key, Channel.PathOf(key.Frame, key.View), _method, _raysCast);
}
