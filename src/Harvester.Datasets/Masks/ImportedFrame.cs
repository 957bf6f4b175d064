using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labels;
using Harvester.Datasets.Sessions;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;

namespace Harvester.Datasets.Masks;

/// <summary>One frame's map in the session's own numbers, and what follows from it for the objects.</summary>
internal sealed class ImportedFrame
{
    /// <summary>As many as docs/dataset-format.md promises.</summary>
    private const int FractionDecimals = 4;

    private static readonly JsonSerializerOptions AsItIs = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    private readonly int _frame;
    private readonly Dictionary<ushort, CuboidPixels> _cuboids;
    private readonly Dictionary<ushort, Box2D> _bounds = [];

    /// <summary>Takes a map and writes the objects' ids into it.</summary>
    /// <exception cref="DatasetFormatException">The map has a number that is no object's id, where it may have none.</exception>
    public ImportedFrame(FrameLabel label, InstanceMap map, MaskNumbers numbers)
    {
        _frame = label.Frame;
        Camera camera = LabelCamera.Of(label.Camera);
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

    /// <summary>The map; its numbers are the objects' ids.</summary>
    public InstanceMap Map { get; }

    /// <summary>How many objects have a pixel.</summary>
    public int Seen => _bounds.Count;

    /// <summary>The frame's line of labels with what follows from the map; all its other fields stay as they are, unknown ones too.</summary>
    public string Rewrite(string line)
    {
        JsonObject label = JsonNode.Parse(line)!.AsObject();
        label["mask"] = FramePaths.Mask(_frame);
        label["pixelMap"] = null;
        foreach (JsonObject item in label["objects"]!.AsArray().Select(item => item!.AsObject()))
        {
            var id = (ushort)item["id"]!.GetValue<int>();
            double occluded = OccludedFraction(id);
            double visible = (1 - item["truncatedFraction"]!.GetValue<double>()) * (1 - occluded);
            item["box2dVisible"] = _bounds.TryGetValue(id, out Box2D box) ? new JsonArray(box.XMin, box.YMin, box.XMax, box.YMax) : null;
            item["boxes"] = new JsonArray([.. BoxKinds.Known(_bounds.ContainsKey(id)).Select(kind => JsonValue.Create(JsonName.Of(kind)))]);
            item["occludedFraction"] = Math.Round(occluded, FractionDecimals);
            item["occlusionMethod"] = JsonName.Of(OcclusionMethod.Imported);
            item["visibleFraction"] = Math.Round(visible, FractionDecimals);
        }

        return label.ToJsonString(AsItIs);
    }

    // Where a nearer object is seen the object is hidden as far as it fills its cuboid's silhouette there. Taking that it fills it there
    // as it does elsewhere, what is hidden of the object is what is covered of the silhouette.
    private double OccludedFraction(ushort id)
    {
        Dictionary<int, double> own = _cuboids[id].Distances;
        if (!_bounds.ContainsKey(id) || own.Count == 0)
        {
            return 1;
        }

        int covered = own.Count(pixel =>
            Map.Ids[pixel.Key] is var other and not 0
            && other != id
            && _cuboids[other].Distances.TryGetValue(pixel.Key, out double distance)
            && distance < pixel.Value);
        return (double)covered / own.Count;
    }

    private void Renumber(MaskNumbers numbers)
    {
        Dictionary<ushort, ushort>? ids = numbers == MaskNumbers.Overlap ? OverlapMatching.Match(Map, [.. _cuboids.Values]) : null;
        for (int i = 0; i < Map.Ids.Length; i++)
        {
            ushort number = Map.Ids[i];
            if (ids is not null)
            {
                Map.Ids[i] = ids.GetValueOrDefault(number);
            }
            else if (number != 0 && !_cuboids.ContainsKey(number))
            {
                throw new DatasetFormatException(
                    $"The map of frame {_frame} has the number {number}, which is no object's id in that frame; numbers of the tool's own need --match.");
            }
        }
    }
}
