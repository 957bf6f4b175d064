using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Masks;

/// <summary>One frame's map in the session's own numbers, and what follows from it for the objects.</summary>
internal sealed class ImportedFrame
{
    /// <summary>As many as docs/dataset-format.md promises.</summary>
    private const int FractionDecimals = 4;

    private static readonly JsonSerializerOptions AsItIs = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    private readonly int _frame;
    private readonly Dictionary<ushort, ObjectLabel> _labels;
    private readonly Dictionary<ushort, CuboidPixels> _cuboids;
    private readonly Dictionary<ushort, Box2D> _bounds = [];

    /// <summary>Takes a map and writes the objects' ids into it.</summary>
    /// <exception cref="DatasetFormatException">The map has a number that is no object's id, where it may have none.</exception>
    public ImportedFrame(FrameLabel label, InstanceMap map, MaskNumbers numbers)
    {
        _frame = label.Frame;
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

    /// <summary>The map; its numbers are the objects' ids, that of the whole object where a part of it is seen.</summary>
    public InstanceMap Map { get; }

    /// <summary>How many objects the map shows anything of.</summary>
    public int Seen => _labels.Keys.Count(IsSeen);

    /// <summary>
    /// The frame's line of labels with what follows from the map; all its other fields stay as they are, unknown ones too.
    /// </summary>
    public string Rewrite(string line)
    {
        JsonObject label = JsonNode.Parse(line)!.AsObject();
        label["mask"] = FramePaths.Mask(_frame);
        label["pixelMap"] = null;
        foreach (JsonObject item in label["objects"]!.AsArray().Select(item => item!.AsObject()))
        {
            var id = (ushort)item["id"]!.GetValue<int>();
            item["box2dVisible"] = _bounds.TryGetValue(id, out Box2D box) ? new JsonArray(box.XMin, box.YMin, box.XMax, box.YMax) : null;
            item["boxes"] = new JsonArray([.. BoxKinds.Known(_bounds.ContainsKey(id)).Select(kind => JsonValue.Create(JsonName.Of(kind)))]);
            if (OccludedFraction(id) is { } occluded)
            {
                item["occludedFraction"] = Math.Round(occluded, FractionDecimals);
                item["occlusionMethod"] = JsonName.Of(OcclusionMethod.Imported);
                item["visibleFraction"] = Math.Round(
                    (1 - item["truncatedFraction"]!.GetValue<double>()) * (1 - occluded), FractionDecimals);
            }
        }

        return label.ToJsonString(AsItIs);
    }

    /// <summary>How much of an object is hidden, by the map; null where the map does not tell and what is known of it stays.</summary>
    private double? OccludedFraction(ushort id) =>
        _labels[id].Parent is null ? IsSeen(id) ? CoveredFraction(id) : 1
        : OwnerOf(id) == 0 || _cuboids[id].Samples.Count == 0 ? null
        : !IsSeen(id) ? 1
        : CoveredFraction(id) is var covered && covered < FoundByRays(id) ? null
        : covered;

    // Where a nearer object is seen the object is hidden as far as it fills its cuboid's silhouette there. Taking that it fills it there
    // as it does elsewhere, what is hidden of the object is what is covered of the silhouette.
    private double CoveredFraction(ushort id)
    {
        IReadOnlyList<(int Pixel, double Distance)> samples = _cuboids[id].Samples;
        return samples.Count == 0 ? 0 : (double)samples.Count(sample => IsCovered(id, sample.Pixel, sample.Distance)) / samples.Count;
    }

    /// <summary>How much rays found hidden of a part, also by the rest of its object, of which the map shows the same number.</summary>
    private double FoundByRays(ushort id) =>
        _labels[id] is { OcclusionMethod: not OcclusionMethod.Imported, OccludedFraction: { } found } ? found : 0;

    /// <summary>Whether another object that is nearer is seen at a pixel.</summary>
    private bool IsCovered(ushort id, int pixel, double distance) =>
        Map.Ids[pixel] is var shown and not 0 && shown != OwnerOf(id) && _cuboids[shown].Distances.TryGetValue(pixel, out double its)
            && its < distance;

    /// <summary>Whether the map shows a pixel of an object, or one of a part's object where the part is.</summary>
    private bool IsSeen(ushort id) =>
        _labels[id].Parent is null ? _bounds.ContainsKey(id) : OwnerOf(id) is var owner and not 0 && _cuboids[id].Shows(Map, owner);

    /// <summary>
    /// The id that an object's pixels have: the part's object's for a part; 0 when that is not listed, so that the part has no pixels.
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
            }
            else if (number != 0)
            {
                Map.Ids[i] = _labels.ContainsKey(number) ? OwnerOf(number) : throw new DatasetFormatException(
                    $"The map of frame {_frame} has the number {number}, which is no object's id in that frame; numbers of the tool's own need --match.");
            }
        }
    }
}
