using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.PixelMaps.Coded;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Makes an instance map from photographs. Objects that change no photograph may be hidden by the world, or the game may not hide them:
/// a few rays decide, and show the pixels of those that it does not hide.
/// </summary>
internal sealed class CodedMapMaker(
    LabellingOptions options,
    Camera camera,
    IReadOnlyList<MapTarget> targets,
    int egoHandle,
    FrameRays rays,
    CodedPictures pictures
)
{
    /// <summary>Maximum number of rays for the objects that change no photograph.</summary>
    private const int MaxRays = 500;

    /// <summary>
    /// An object that rays meet, but that changes no photograph, is drawn from rays if they show this many pixels of it. Fewer may be a
    /// corner of its collision hull.
    /// </summary>
    private const int MinPixelsFromRays = 256;

    /// <summary>The map; null until it is made.</summary>
    public MadeMap? Made { get; private set; }

    /// <summary>Makes the map, in steps.</summary>
    /// <param name="mayCastRays">Called before each ray.</param>
    public IEnumerable<WorkStep> Make(Func<bool> mayCastRays)
    {
        IMaskDecoder decoder = pictures.Plan.Decoder(pictures.Pictures);
        yield return WorkStep.Do(decoder.Decode());
        CodedMask mask = decoder.Mask!;
        MapTarget[] missing =
        [
            .. targets.Where(target => !mask.Amodal.TryGetValue(target.Number, out PixelMap? amodal) || amodal.Count == 0),
        ];
        var mapper = new AdaptivePixelMapper(
            camera,
            missing,
            egoHandle,
            rays,
            new PixelMapOptions { RayBudget = Math.Min(MaxRays, rays.Left), RayReachMetres = options.RayReachMetres }
        );
        while (mayCastRays() && mapper.Step())
        {
            yield return WorkStep.Pause;
        }

        AdaptivePixelMap rest = mapper.Finish();
        var sights = new Dictionary<ushort, Sight>();
        Draw(mask.Map, rest, missing, PixelCounts(rest.Map), sights);
        int[] visible = PixelCounts(mask.Map);
        foreach (MapTarget target in targets)
        {
            if (!sights.ContainsKey(target.Number))
            {
                sights[target.Number] = visible[target.Number] > 0 ? Sight.Seen : Sight.Unseen;
            }
        }

        Made = new MadeMap(
            mask.Map,
            sights,
            new PixelMapLabel(1, 0, rest.RaysCast) { Pictures = pictures.Pictures.Count, UndeterminedPixels = mask.Undetermined.Count }
        )
        {
            Amodal = mask.Amodal,
        };
    }

    private int[] PixelCounts(InstanceMap map)
    {
        int[] counts = new int[targets.Count + 1];
        foreach (ushort number in map.Ids)
        {
            counts[number]++;
        }

        return counts;
    }

    private static void Draw(InstanceMap map, AdaptivePixelMap rest, MapTarget[] missing, int[] counts, Dictionary<ushort, Sight> sights)
    {
        foreach (MapTarget target in missing)
        {
            bool isDrawn = counts[target.Number] >= MinPixelsFromRays;
            Sight sight = rest.Sights[target.Number];
            sights[target.Number] = sight == Sight.Seen && !isDrawn ? Sight.Unseen : sight;
            for (int i = 0; isDrawn && i < map.Ids.Length; i++)
            {
                if (map.Ids[i] == 0 && rest.Map.Ids[i] == target.Number)
                {
                    map.Ids[i] = target.Number;
                }
            }
        }
    }
}
