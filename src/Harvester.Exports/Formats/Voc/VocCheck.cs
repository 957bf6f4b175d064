using System.Globalization;
using System.Xml;
using System.Xml.Linq;
using Harvester.Exports.Checks;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Voc;

/// <summary>
/// Checks Pascal VOC datasets: every image has its annotation and is in a list, and boxes, counted from 1, lie in the image.
/// </summary>
internal static class VocCheck
{
    private const string Images = "JPEGImages";
    private const string Annotations = "Annotations";
    private static readonly string[] Flags = ["truncated", "occluded", "difficult"];

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        IReadOnlyList<string> images = dataset.Files(Images);
        Dictionary<string, int> frames = images.ToDictionary(image => Path.GetFileNameWithoutExtension(image), _ => 1);
        HashSet<string> classes = [.. new ClassCatalogue(dataset.Options).All.Select(kind => kind.Name)];
        return images
            .SelectMany(image => ProblemsOf(dataset, image, classes))
            .Concat(LabelFiles.Strays(dataset, Annotations, frames.Keys))
            .Concat(SplitLists.Problems(dataset, split => $"ImageSets/Main/{split}.txt", frames))
            .Concat(LabelMapProblems(dataset, classes));
    }

    private static IEnumerable<SessionProblem> LabelMapProblems(DatasetContent dataset, HashSet<string> classes)
    {
        HashSet<string> listed = [.. dataset.Lines(VocWriter.LabelMapFile).Select(line => line.Text.Split(':')[0])];
        return classes
            .Where(name => !listed.Contains(name))
            .Select(name => new SessionProblem(VocWriter.LabelMapFile, null, $"the class '{name}' is missing."));
    }

    private static IEnumerable<SessionProblem> ProblemsOf(DatasetContent dataset, string image, HashSet<string> classes)
    {
        string name = $"{Annotations}/{Path.GetFileNameWithoutExtension(image)}.xml";
        if (!dataset.Has(name))
        {
            return [new SessionProblem(name, null, "it is missing, but its image exists.")];
        }

        try
        {
            using XmlReader reader = XmlReader.Create(new MemoryStream(InputFile.ReadAllBytes(dataset.PathOf(name))));
            XElement annotation = XElement.Load(reader, LoadOptions.SetLineInfo);
            return
            [
                .. FrameProblems(dataset, image, annotation)
                    .Concat(annotation.Elements("object").SelectMany(item => ObjectProblems(item, annotation, classes)))
                    .Select(found => new SessionProblem(name, ((IXmlLineInfo)found.At).LineNumber, found.Message)),
            ];
        }
        catch (XmlException e)
        {
            return [new SessionProblem(name, e.LineNumber, "it is not valid XML from here on.")];
        }
    }

    private static IEnumerable<(XElement At, string Message)> FrameProblems(DatasetContent dataset, string image, XElement annotation)
    {
        if (annotation.Element("filename")?.Value != Path.GetFileName(image))
        {
            yield return (annotation.Element("filename") ?? annotation, $"filename is not '{Path.GetFileName(image)}'.");
        }

        XElement size = annotation.Element("size") ?? annotation;
        if (dataset.Header(image) is { } header && (Whole(size, "width"), Whole(size, "height")) != (header.Size.Width, header.Size.Height))
        {
            yield return (size, $"its size is not that of the image, {header.Size.Width} x {header.Size.Height}.");
        }
    }

    private static IEnumerable<(XElement At, string Message)> ObjectProblems(XElement item, XElement annotation, HashSet<string> classes)
    {
        if (!classes.Contains(item.Element("name")?.Value ?? ""))
        {
            yield return (item, $"'{item.Element("name")?.Value}' is not a class of the export.");
        }

        foreach (string flag in Flags.Where(flag => Whole(item, flag) is not (0 or 1)))
        {
            yield return (item, $"{flag} is not 0 or 1.");
        }

        XElement box = item.Element("bndbox") ?? item;
        XElement size = annotation.Element("size") ?? annotation;
        if (
            !IsRange(Whole(box, "xmin"), Whole(box, "xmax"), Whole(size, "width"))
            || !IsRange(Whole(box, "ymin"), Whole(box, "ymax"), Whole(size, "height"))
        )
        {
            yield return (box, "its box does not lie in the image.");
        }
    }

    private static bool IsRange(int? first, int? last, int? size) => first >= 1 && first <= last && last <= size;

    private static int? Whole(XElement parent, string name) =>
        int.TryParse(parent.Element(name)?.Value, NumberStyles.None, CultureInfo.InvariantCulture, out int value) ? value : null;
}
