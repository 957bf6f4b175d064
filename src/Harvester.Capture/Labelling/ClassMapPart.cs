using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>The class map of a frame.</summary>
/// <param name="map">The classes, pixel by pixel.</param>
/// <param name="method">Where they come from.</param>
/// <param name="raysCast">The rays cast for it.</param>
/// <param name="interpolatedPixels">Number of its pixels that show no object of the mask and were drawn without a ray.</param>
public sealed class ClassMapPart(InstanceMap map, SemanticsMethod method, int raysCast, int interpolatedPixels) : FramePart
{
    /// <summary>The classes, pixel by pixel.</summary>
    public InstanceMap Map => map;

    /// <inheritdoc />
    protected override IReadOnlyList<FileContent> Contents => [Grey8(map)];

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key) =>
        new ClassMapLabel(FramePaths.Classes(key.Frame, key.View), method, raysCast, interpolatedPixels);

    internal override void Complete(InstanceMap? mask, PixelBuffer picture)
    {
        if (method == SemanticsMethod.Rays)
        {
            ClassMapColours.Complete(map, mask, picture);
        }
    }
}
