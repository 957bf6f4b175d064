using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Masks;

/// <summary>A frame's map with the session's ids, and the labels that follow from it.</summary>
internal sealed class ImportedFrame
{
    /// <summary>Number of decimals that docs/dataset-format.md specifies.</summary>
    private const int FractionDecimals = 4;

    private static readonly JsonSerializerOptions AsItIs = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    private readonly int _frame;
    private readonly string? _view;
    private readonly Dictionary<ushort, ObjectLabel> _labels;
    private readonly Dictionary<ushort, CuboidPixels> _cuboids;
    private readonly Dictionary<ushort, Box2D> _bounds = [];
    private readonly SortedSet<int> _dropped = [];

    /// <summary>Reads a map and replaces its values by object ids.</summary>
    /// <exception cref="DatasetFormatException">The map has a value that is not an object id, where the values must be ids.</exception>
    public ImportedFrame(FrameLabel label, InstanceMap map, MaskNumbers numbers)
    {
        _frame = label.Frame;
        _view = label.View;
        Camera camera = LabelCamera.Of(label.Camera);
        _labels = label.Objects.ToDictionary(item => (ushort)item.Id);
        _cuboids = label.Objects.ToDictionary(item => (ushort)item.Id, item => new CuboidPixels(camera, item));
        Map = map;
        Renumber(numbers);
        for (int i = 0; i < map.Ids.Length; i++)
        {
            if (map.Ids[i] is var id and not 0)
            {
                int column = i % map.Image.Width;
                int row = i / map.Image.Width;
                var pixel = new Box2D(column, row, column + 1, row + 1);
                _bounds[id] = _bounds.TryGetValue(id, out Box2D known) ? known.Union(pixel) : pixel;
            }
        }
    }

    /// <summary>The map; its values are object ids. A part has the id of its whole object.</summary>
    public InstanceMap Map { get; }

    /// <summary>Number of pixels whose value matches no object.</summary>
    public int DroppedPixels { get; private set; }

    /// <summary>The values of these pixels, ascending.</summary>
    public IReadOnlyList<int> DroppedValues => [.. _dropped];

    /// <summary>Number of objects with at least one pixel.</summary>
    public int Seen => _labels.Keys.Count(IsSeen);

    /// <summary>The label line with the fields that follow from the map; all other fields, even unknown ones, are unchanged.</summary>
    public string Rewrite(string line)
    {
        JsonObject label = JsonNode.Parse(line)!.AsObject();
        label["mask"] = FramePaths.Mask(_frame, _view);
        label["pixelMap"] = null;
        foreach (JsonObject item in label["objects"]!.AsArray().Select(item => item!.AsObject()))
        {
            var id = (ushort)item["id"]!.GetValue<int>();
            item["box2dVisible"] = _bounds.TryGetValue(id, out Box2D box) ? new JsonArray(box.XMin, box.YMin, box.XMax, box.YMax) : null;
            item.Remove("amodalMask");
            item.Remove("box2dWhole");
            item["boxes"] = new JsonArray([.. BoxKinds.Known(_bounds.ContainsKey(id)).Select(kind => JsonValue.Create(JsonName.Of(kind)))]);
            if (OccludedFraction(id) is { } occluded)
            {
                item["occludedFraction"] = Math.Round(occluded, FractionDecimals);
                item["occlusionMethod"] = JsonName.Of(OcclusionMethod.Imported);
                item["visibleFraction"] = Math.Round(
                    (1 - item["truncatedFraction"]!.GetValue<double>()) * (1 - occluded),
                    FractionDecimals
                );
            }
        }

        return label.ToJsonString(AsItIs);
    }

    /// <summary>The occluded fraction by the map; null if the map does not determine it and the known one stays.</summary>
    private double? OccludedFraction(ushort id) =>
        _labels[id].Parent is null
            ? IsSeen(id)
                ? CoveredFraction(id)
                : 1
            : OwnerOf(id) == 0 || _cuboids[id].Samples.Count == 0
                ? null
                : !IsSeen(id)
                    ? 1
                    : CoveredFraction(id) is var covered && covered < FoundByRays(id)
                        ? null
                        : covered;

    // Where a nearer object is visible, the object is hidden as far as it fills its silhouette there. If it fills that part like the rest,
    // the occluded fraction of the object is that of the silhouette.
    private double CoveredFraction(ushort id)
    {
        IReadOnlyList<(int Pixel, double Distance)> samples = _cuboids[id].Samples;
        return samples.Count == 0 ? 0 : (double)samples.Count(sample => IsCovered(id, sample.Pixel, sample.Distance)) / samples.Count;
    }

    /// <summary>
    /// The occluded fraction of a part by rays, which also hit the rest of its object; the map has the same value for both.
    /// </summary>
    private double FoundByRays(ushort id) =>
        _labels[id] is { OcclusionMethod: not OcclusionMethod.Imported, OccludedFraction: { } found } ? found : 0;

    /// <summary>Whether a nearer object is visible at a pixel.</summary>
    private bool IsCovered(ushort id, int pixel, double distance) =>
        Map.Ids[pixel] is var shown and not 0
        && shown != OwnerOf(id)
        && _cuboids[shown].Distances.TryGetValue(pixel, out double its)
        && its < distance;

    /// <summary>Whether a pixel shows an object or, for a part, its whole object.</summary>
    private bool IsSeen(ushort id) =>
        _labels[id].Parent is null ? _bounds.ContainsKey(id) : OwnerOf(id) is var owner and not 0 && _cuboids[id].Shows(Map, owner);

    /// <summary>
    /// The id of an object's pixels: for a part, that of its whole object; 0 if the whole object is not listed, so that the part has no
    /// pixels.
    /// </summary>
    private ushort OwnerOf(ushort id) =>
        _labels[id].Parent is not { } parent ? id
        : _labels.ContainsKey((ushort)parent) ? (ushort)parent
        : (ushort)0;

    private void Renumber(MaskNumbers numbers)
    {
        Dictionary<ushort, ushort>? ids = numbers == MaskNumbers.Overlap ? OverlapMatching.Match(Map, [.. _cuboids.Values], OwnerOf) : null;
        for (int i = 0; i < Map.Ids.Length; i++)
        {
            ushort number = Map.Ids[i];
            if (ids is not null)
            {
                Map.Ids[i] = ids.GetValueOrDefault(number);
                if (number != 0 && Map.Ids[i] == 0)
                {
                    DroppedPixels++;
                    _dropped.Add(number);
                }
            }
            else if (number != 0)
            {
                Map.Ids[i] = _labels.ContainsKey(number)
                    ? OwnerOf(number)
                    : throw new DatasetFormatException(
                        $"The mask of frame {_frame} has the value {number}, which is not the id of an object in that frame. If the values "
                            + "are not ids, use --match."
                    );
            }
        }
    }
}
