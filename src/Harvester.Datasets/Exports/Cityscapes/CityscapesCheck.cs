using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Harvester.Datasets.Exports.Validation;
using Harvester.Datasets.Images;
using Harvester.Datasets.Validation;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Exports.Cityscapes;

/// <summary>What must hold for maps in the style of Cityscapes: every image has its two maps, of its size, which say the same.</summary>
internal static class CityscapesCheck
{
    private const string ImageEnd = "_leftImg8bit";

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset) =>
        dataset.Splits.SelectMany(split => dataset.Folders($"leftImg8bit/{split}").Select(Path.GetFileName).SelectMany(city => CityProblems(dataset, split, city!)))
            .Concat(TwiceProblems(dataset));

    private static IEnumerable<SessionProblem> CityProblems(DatasetContent dataset, string split, string city)
    {
        string maps = $"gtFine/{split}/{city}";
        var known = new HashSet<string>(StringComparer.Ordinal);
        foreach (string image in dataset.Files($"leftImg8bit/{split}/{city}"))
        {
            dataset.Found(split);
            string frame = Path.GetFileNameWithoutExtension(image).Replace(ImageEnd, "", StringComparison.Ordinal);
            (string instances, string labels) = ($"{maps}/{frame}_gtFine_instanceIds.png", $"{maps}/{frame}_gtFine_labelIds.png");
            known.UnionWith([instances, labels]);
            if (MapProblem(dataset, image, instances, labels) is { } problem)
            {
                yield return problem;
            }
        }

        foreach (string map in dataset.Files(maps).Where(map => !known.Contains(map)))
        {
            yield return new SessionProblem(map, null, "its image is missing.");
        }
    }

    private static SessionProblem? MapProblem(DatasetContent dataset, string image, string instances, string labels)
    {
        string name = instances;
        try
        {
            foreach (string map in (string[])[instances, labels])
            {
                name = map;
                if (!dataset.Has(map))
                {
                    return new SessionProblem(map, null, "it is missing, but its image is there.");
                }

                if (dataset.Header(image) is { } header && dataset.Header(map) is { } own && own.Size != header.Size)
                {
                    return new SessionProblem(map, null, $"it is {own.Size.Width} x {own.Size.Height}, but its image is {header.Size.Width} x {header.Size.Height}.");
                }
            }

            name = labels;
            InstanceMap labelMap = PngDecoder.ReadLabelMap(dataset.PathOf(labels));
            name = instances;
            string? problem = PixelProblem(PngDecoder.ReadInstanceMap(dataset.PathOf(instances)), labelMap);
            return problem is null ? null : new SessionProblem(name, null, problem);
        }
        catch (DatasetFormatException e)
        {
            return new SessionProblem(name, null, e.Message);
        }
    }

    private static string? PixelProblem(InstanceMap instances, InstanceMap labels)
    {
        int width = instances.Image.Width;
        for (int i = 0; i < instances.Ids.Length; i++)
        {
            ushort instance = instances.Ids[i];
            ushort label = CityscapesLabels.LabelOfInstance(instance);
            string place = FormattableString.Invariant($"at column {i % width}, row {i / width}");
            if (label != labels.Ids[i])
            {
                return $"{place}, instance {instance} is not of label {labels.Ids[i]}.";
            }
        }

        ushort? wrong = instances.Ids.Distinct().Select(id => (ushort?)id).FirstOrDefault(id => !CityscapesLabels.IsInstance(id!.Value));
        return wrong is null ? null : $"{wrong} is no instance of a label that is exported.";
    }

    private static IEnumerable<SessionProblem> TwiceProblems(DatasetContent dataset) => dataset.Splits
        .SelectMany(split => dataset.Folders($"leftImg8bit/{split}")).SelectMany(dataset.Files)
        .GroupBy(image => Path.GetFileName(image), StringComparer.Ordinal).SelectMany(same => same.Skip(1))
        .Select(image => new SessionProblem(image, null, "it is in another split too."));
}
