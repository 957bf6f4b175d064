using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Cityscapes;

/// <summary>Checks Cityscapes maps: every image has three consistent maps of its size, and polygons.</summary>
internal static class CityscapesCheck
{
    private const string ImageEnd = "_leftImg8bit";
    private const string Instances = "instanceIds.png";
    private const string Labels = "labelIds.png";
    private const string TrainLabels = "labelTrainIds.png";

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset) =>
        dataset
            .Splits.SelectMany(split =>
                dataset.Folders($"leftImg8bit/{split}").Select(Path.GetFileName).SelectMany(city => CityProblems(dataset, split, city!))
            )
            .Concat(TwiceProblems(dataset));

    private static IEnumerable<SessionProblem> CityProblems(DatasetContent dataset, string split, string city)
    {
        string maps = $"gtFine/{split}/{city}";
        var known = new HashSet<string>(StringComparer.Ordinal);
        foreach (string image in dataset.Files($"leftImg8bit/{split}/{city}"))
        {
            dataset.Found(split);
            string frame = Path.GetFileNameWithoutExtension(image).Replace(ImageEnd, "", StringComparison.Ordinal);
            string map = $"{maps}/{frame}_gtFine_";
            string polygons = map + "polygons.json";
            known.UnionWith([map + Instances, map + Labels, map + TrainLabels, polygons]);
            if (MapProblem(dataset, image, map) is { } problem)
            {
                yield return problem;
            }

            if (PolygonProblem(dataset, polygons) is { } message)
            {
                yield return new SessionProblem(polygons, null, message);
            }
        }

        foreach (string stray in dataset.Files(maps).Where(file => !known.Contains(file)))
        {
            yield return new SessionProblem(stray, null, "its image is missing.");
        }
    }

    private static SessionProblem? MapProblem(DatasetContent dataset, string image, string map)
    {
        string name = map + Instances;
        try
        {
            foreach (string kind in (string[])[Instances, Labels, TrainLabels])
            {
                name = map + kind;
                if (!dataset.Has(name))
                {
                    return new SessionProblem(name, null, "it is missing, but its image exists.");
                }

                if (dataset.Header(image) is { } header && dataset.Header(name) is { } own && own.Size != header.Size)
                {
                    return new SessionProblem(
                        name,
                        null,
                        $"it is {own.Size.Width} x {own.Size.Height}, but its image is {header.Size.Width} x {header.Size.Height}."
                    );
                }
            }

            name = map + Labels;
            InstanceMap labels = PngDecoder.ReadLabelMap(dataset.PathOf(name));
            name = map + TrainLabels;
            InstanceMap trainLabels = PngDecoder.ReadLabelMap(dataset.PathOf(name));
            name = map + Instances;
            string? problem = PixelProblem(PngDecoder.ReadInstanceMap(dataset.PathOf(name)), labels, trainLabels);
            return problem is null ? null : new SessionProblem(name, null, problem);
        }
        catch (DatasetFormatException e)
        {
            return new SessionProblem(name, null, e.Message);
        }
    }

    private static string? PixelProblem(InstanceMap instances, InstanceMap labels, InstanceMap trainLabels)
    {
        int width = instances.Image.Width;
        Dictionary<ushort, CityscapesLabel?> labelOf = instances
            .Ids.Distinct()
            .ToDictionary(instance => instance, CityscapesLabels.OfInstance);
        for (int i = 0; i < instances.Ids.Length; i++)
        {
            ushort instance = instances.Ids[i];
            if (labelOf[instance] is not { } label)
            {
                return $"{instance} is not an instance of an exported label.";
            }

            string place = FormattableString.Invariant($"at column {i % width}, row {i / width}");
            if (label.Id != labels.Ids[i])
            {
                return $"{place}, instance {instance} is not of label {labels.Ids[i]}.";
            }

            if (label.TrainId != trainLabels.Ids[i])
            {
                return $"{place}, label {label.Id} is not {trainLabels.Ids[i]} for training.";
            }
        }

        return null;
    }

    private static string? PolygonProblem(DatasetContent dataset, string name)
    {
        if (!dataset.Has(name))
        {
            return "it is missing, but its image exists.";
        }

        try
        {
            using JsonDocument document = JsonInput.Read(dataset.PathOf(name));
            var fields = new JsonFields(document.RootElement);
            var image = new Box2D(0, 0, fields.Integer("imgWidth") - 1, fields.Integer("imgHeight") - 1);
            return fields
                .List("objects")
                .Select((item, index) => ObjectProblem(item, image) is { } problem ? $"objects[{index}]: {problem}" : null)
                .FirstOrDefault(problem => problem is not null);
        }
        catch (JsonException e)
        {
            return JsonFault.InText(e);
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }
    }

    private static string? ObjectProblem(JsonFields item, Box2D image) =>
        !CityscapesLabels.Names.Contains(item.Text("label")) ? $"'{item.Text("label")}' is not an exported label."
        : item.Rows("polygon").All(corner => corner.Length == 2 && image.Contains(new Box2D(corner[0], corner[1], corner[0], corner[1]), 0))
            ? null
        : "its polygon does not lie in the image.";

    private static IEnumerable<SessionProblem> TwiceProblems(DatasetContent dataset) =>
        dataset
            .Splits.SelectMany(split => dataset.Folders($"leftImg8bit/{split}"))
            .SelectMany(dataset.Files)
            .GroupBy(image => Path.GetFileName(image), StringComparer.Ordinal)
            .SelectMany(same => same.Skip(1))
            .Select(image => new SessionProblem(image, null, "it is in another split too."));
}
