using System.Text.Json;
using Harvester.Datasets.Detections;
using Harvester.Datasets.Masks.Pixels;
using Harvester.Exports.Formats.Coco;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Predictions;

/// <summary>
/// Predictions as COCO results: a JSON list of objects with image_id, category_id, score, and bbox or segmentation. All are held in memory.
/// </summary>
internal sealed class CocoPredictions : IPredictions
{
    /// <summary>With 48 bytes here and 24 in the evaluation, they need less than 1 GB.</summary>
    private const int MaxPredictions = 10_000_000;

    private const int BoxNumbers = 4;

    private readonly PredictedBox[] _boxes;
    private readonly int[] _starts;

    private CocoPredictions(IReadOnlyList<DatasetClass> classes, PredictedBox[] boxes, int[] starts)
    {
        _boxes = boxes;
        _starts = starts;
        Classes = [.. classes.Select(kind => new PredictedClass(kind.Name, kind.Kind))];
    }

    public string Format => "COCO";

    public IReadOnlyList<PredictedClass> Classes { get; }

    public double ToSessionPixels => 0;

    /// <summary>Reads a file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="images">Number of images: their ids are 0 to one less.</param>
    /// <param name="options">The options of the export.</param>
    /// <exception cref="DatasetFormatException">The file is malformed, or names an image or category that the session lacks.</exception>
    public static CocoPredictions Read(string path, int images, ExportOptions options)
    {
        IReadOnlyList<DatasetClass> classes = new ClassCatalogue(options).All;
        Dictionary<int, int> places = classes.ToDictionary(kind => kind.Category, kind => kind.Number);
        var boxes = new List<PredictedBox>();
        int[] starts = new int[images + 1];
        using var reader = new JsonListReader(path, isBare: true);
        while (HasNext(reader, path))
        {
            if (boxes.Count == MaxPredictions)
            {
                throw new DatasetFormatException(
                    $"'{path}' has more than {MaxPredictions} predictions, the limit. " + "Leave out those with the lowest scores."
                );
            }

            PredictedBox box = Parse(reader, path, images, places);
            starts[box.Image + 1]++;
            boxes.Add(box);
        }

        if (!reader.HasList)
        {
            throw new DatasetFormatException(
                $"'{path}' is not COCO results: it must be a JSON list of predictions, "
                    + """[{"image_id": 0, "category_id": 1, "bbox": [x, y, width, height], "score": 0.9}, ...]."""
            );
        }

        return new CocoPredictions(classes, Grouped(boxes, starts), starts);
    }

    public int? ImageOf(ExportFrame frame) => frame.Index;

    public IEnumerable<TruthObject> TruthOf(ExportFrame frame)
    {
        foreach (ExportObject item in frame.Objects)
        {
            InstancePixels? pixels = frame.PixelsOf(item.Label);
            if (frame.Mask is null || pixels is not null)
            {
                Box2D box = Rounded(item.Box);
                yield return new TruthObject(new TruthBox(item.Class.Number, box, pixels?.Area ?? box.Area, IsCrowd: false), item.Label);
            }
        }

        foreach (ExportRegion region in frame.Ignored)
        {
            if (region.Class is { } kind)
            {
                Box2D box = Rounded(region.Box);
                yield return new TruthObject(new TruthBox(kind.Number, box, box.Area, IsCrowd: true), region.Label);
            }
        }
    }

    public IReadOnlyList<PredictedBox> For(int image) =>
        new ArraySegment<PredictedBox>(_boxes, _starts[image], _starts[image + 1] - _starts[image]);

    public void CheckImages(IReadOnlySet<int> images)
    {
        // Each was checked on reading.
    }

    private static bool HasNext(JsonListReader reader, string path)
    {
        try
        {
            return reader.Read();
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException($"'{path}': {JsonFault.InText(e)} JSON has no NaN and Infinity.", e);
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"'{path}': {e.Message}", e);
        }
    }

    private static PredictedBox Parse(JsonListReader reader, string path, int images, Dictionary<int, int> places)
    {
        try
        {
            var fields = new JsonFields(reader.Element);
            long image = fields.LongInteger("image_id");
            int category = fields.Integer("category_id");
            double[] box =
                fields.Has("bbox") || !fields.Has("segmentation")
                    ? fields.Numbers("bbox", BoxNumbers)
                    : SegmentationBounds.Of(reader.Element.GetProperty("segmentation"));
            double score = fields.Number("score");
            string? problem =
                image < 0 || image >= images ? $"image_id {image} is unknown; the images of the session are 0 to {images - 1}."
                : !places.ContainsKey(category)
                    ? $"category_id {category} is unknown; the categories are {string.Join(", ", places.Keys)} (docs/exports/coco.md)."
                : box[2] < 0 || box[3] < 0 ? $"bbox is x, y, width, height; width and height are {box[2]} and {box[3]}, less than 0."
                : null;
            return problem is null
                ? new PredictedBox((int)image, places[category], new Box2D(box[0], box[1], box[0] + box[2], box[1] + box[3]), score)
                : throw new DatasetFormatException(problem);
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"'{path}', line {reader.Line}: {e.Message}", e);
        }
    }

    /// <summary>Sorts the predictions by image, in the order of the file within each, and makes starts out of counts.</summary>
    private static PredictedBox[] Grouped(List<PredictedBox> boxes, int[] starts)
    {
        for (int image = 1; image < starts.Length; image++)
        {
            starts[image] += starts[image - 1];
        }

        var grouped = new PredictedBox[boxes.Count];
        int[] next = [.. starts];
        foreach (PredictedBox box in boxes)
        {
            grouped[next[box.Image]++] = box;
        }

        return grouped;
    }

    /// <summary>A box as the file of the export has it.</summary>
    private static Box2D Rounded(Box2D box)
    {
        double left = Rounded(box.XMin);
        double top = Rounded(box.YMin);
        return new Box2D(left, top, left + Rounded(box.Width), top + Rounded(box.Height));
    }

    private static double Rounded(double side) => Numbers.Rounded(CocoJson.PixelDecimals, side);
}
