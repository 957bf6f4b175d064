using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Semantics;

namespace Harvester.Exports.Formats.Semantic;

/// <summary>Checks exported class maps: each image has a map of its size whose values are classes, and the drivable area of that.</summary>
internal static class SemanticCheck
{
    private const string ClassFile = "classes.json";

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        if (!dataset.Has(ClassFile))
        {
            yield return new SessionProblem(ClassFile, null, "it is missing.");
        }

        foreach (string split in dataset.Splits)
        {
            var known = new HashSet<string>(StringComparer.Ordinal);
            foreach (string image in dataset.Files($"images/{split}"))
            {
                dataset.Found(split);
                string name = Path.GetFileNameWithoutExtension(image) + ".png";
                known.Add(name);
                if (Problem(dataset, image, $"classes/{split}/{name}", $"drivable/{split}/{name}") is { } problem)
                {
                    yield return problem;
                }
            }

            foreach (
                string stray in dataset
                    .Files($"classes/{split}")
                    .Concat(dataset.Files($"drivable/{split}"))
                    .Where(file => !known.Contains(Path.GetFileName(file)))
            )
            {
                yield return new SessionProblem(stray, null, "its image is missing.");
            }
        }
    }

    private static SessionProblem? Problem(DatasetContent dataset, string image, string map, string drivable)
    {
        string name = map;
        try
        {
            foreach (string file in (string[])[map, drivable])
            {
                name = file;
                if (!dataset.Has(file))
                {
                    return new SessionProblem(file, null, "it is missing, but its image exists.");
                }

                if (dataset.Header(image) is { } header && dataset.Header(file) is { } own && own.Size != header.Size)
                {
                    return new SessionProblem(file, null, "its size is not that of its image.");
                }
            }

            name = map;
            InstanceMap classes = PngDecoder.ReadLabelMap(dataset.PathOf(map));
            if (classes.Ids.FirstOrDefault(value => value > SemanticClasses.Greatest) is var stray and not 0)
            {
                return new SessionProblem(map, null, $"its value {stray} is no class.");
            }

            name = drivable;
            return SemanticWriter.DrivableIn(classes).Ids.AsSpan().SequenceEqual(PngDecoder.ReadLabelMap(dataset.PathOf(drivable)).Ids)
                ? null
                : new SessionProblem(drivable, null, "it is not the road and its markings in the class map.");
        }
        catch (DatasetFormatException e)
        {
            return new SessionProblem(name, null, e.Message);
        }
    }
}
