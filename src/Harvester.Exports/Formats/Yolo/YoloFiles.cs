using System.Text;

namespace Harvester.Exports.Formats.Yolo;

/// <summary>The folders, class numbers and data.yaml of Ultralytics datasets, for boxes and for outlines.</summary>
internal sealed class YoloFiles(ExportOptions options)
{
    public const int Decimals = 6;
    private const string TrainSplit = "train";
    private const string ValSplit = "val";

    private readonly ClassCatalogue _classes = new(options);

    /// <summary>Writes the files of a frame, with one line per object, and returns the number of objects.</summary>
    public static WrittenObjects Write(ExportFrame frame, FrameOutput output, IReadOnlyCollection<string> lines)
    {
        output.Image($"images/{frame.Split}/{frame.Name}{frame.ImageExtension}", frame);
        output.Text($"labels/{frame.Split}/{frame.Name}.txt", string.Concat(lines.Select(line => line + "\n")));
        return new WrittenObjects(lines.Count);
    }

    /// <summary>data.yaml. The library requires train and val; if one is missing, the first split is used instead.</summary>
    public AggregateFile DataFile()
    {
        string[] splits = [.. options.Splits.Splits.Select(split => split.Name)];
        var text = new StringBuilder("# Paths are relative to this file.\n");
        foreach (string name in splits.Union([TrainSplit, ValSplit]))
        {
            text.Append(YamlScalar.Of(name)).Append(": images/").Append(splits.Contains(name) ? name : splits[0]).Append('\n');
        }

        text.Append("names:\n");
        foreach (DatasetClass kind in _classes.All)
        {
            text.Append("  ").Append(Numbers.Text(kind.Number)).Append(": ").Append(YamlScalar.Of(kind.Name)).Append('\n');
        }

        return new AggregateFile("data.yaml", [AggregateSection.Literal(text.ToString())]);
    }
}
