using Harvester.Geometry.Depth;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Makes the depth maps of a frame: the sparse one from the frame's rays and further ones of its own, and with a mask the completed one.
/// </summary>
internal sealed class DepthLabeller(FrameRays rays) : IChannelLabeller
{
    /// <inheritdoc />
    public ChannelTurn Turn => ChannelTurn.Last;

    /// <inheritdoc />
    public string RaysKey => FrameChannels.Depth.RaysKey;

    /// <inheritdoc />
    public IEnumerable<WorkStep> Label(FrameDraft draft, Func<bool> mayCastRays)
    {
        var surfaces = new FrameSurfaces(rays, draft);
        yield return WorkStep.Do(surfaces.Sample(mayCastRays));

        var sparse = new InstanceMap(draft.Camera.Image);
        foreach ((int column, int row, double depth) in surfaces.Hits)
        {
            Measure(sparse, column, row, depth);
        }

        foreach (KeyValuePair<int, DepthSample> sample in surfaces.Samples)
        {
            Measure(sparse, sample.Key % sparse.Image.Width, sample.Key / sparse.Image.Width, sample.Value.Depth);
        }

        DepthMap completed = surfaces.Complete();
        bool hasMask = draft.Mask is not null;
        draft.Add(
            new DepthMaps(
                sparse,
                hasMask ? Units(completed, completed.Metres, DepthUnits.OfDepth) : null,
                hasMask ? Units(completed, completed.ErrorMetres, DepthUnits.OfError) : null,
                surfaces.RaysCast
            )
            {
                Estimate = completed,
            }
        );
    }

    /// <summary>Enters a measured depth; of several in a pixel, the nearest counts.</summary>
    private static void Measure(InstanceMap sparse, int column, int row, double metres)
    {
        ushort depth = DepthUnits.OfDepth(metres);
        ushort known = sparse[column, row];
        sparse[column, row] = known == 0 || (depth != 0 && depth < known) ? depth : known;
    }

    private static InstanceMap Units(DepthMap map, double[] values, Func<double, ushort> unitsOf)
    {
        var units = new InstanceMap(map.Image);
        for (int i = 0; i < values.Length; i++)
        {
            units.Ids[i] = DepthUnits.OfDepth(map.Metres[i]) == 0 ? (ushort)0 : unitsOf(values[i]);
        }

        return units;
    }
}
