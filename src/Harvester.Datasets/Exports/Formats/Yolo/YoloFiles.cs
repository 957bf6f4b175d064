using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Harvester.Datasets.Exports.Formats.Yolo;

/// <summary>What both kinds of Ultralytics datasets have in common: folders, numbers of the classes and data.yaml.</summary>
internal sealed class YoloFiles(ExportOptions options)
{
    public const int Decimals = 6;
    private const string TrainSplit = "train";
    private const string ValSplit = "val";

    private readonly ClassCatalogue _classes = new(options);

    /// <summary>Writes a frame's files and says how many objects they have, a line each.</summary>
    public static WrittenObjects Write(ExportFrame frame, FrameOutput output, IReadOnlyCollection<string> lines)
    {
        output.Image($"images/{frame.Split}/{frame.Name}{frame.ImageExtension}", frame);
        output.Text($"labels/{frame.Split}/{frame.Name}.txt", string.Concat(lines.Select(line => line + "\n")));
        return new WrittenObjects(lines.Count);
    }

    /// <summary>data.yaml. The library asks for train and val; where a split is not there, the first one stands in for it.</summary>
    public AggregateFile DataFile()
    {
        string[] splits = [.. options.Splits.Splits.Select(split => split.Name)];
        var text = new StringBuilder("# Paths are relative to this file.\n");
        foreach (string name in splits.Union([TrainSplit, ValSplit]))
        {
            text.Append(name).Append(": images/").Append(splits.Contains(name) ? name : splits[0]).Append('\n');
        }

        text.Append("names:\n");
        foreach (DatasetClass kind in _classes.All)
        {
            text.Append("  ").Append(Numbers.Text(kind.Number)).Append(": ").Append(kind.Name).Append('\n');
        }

        return new AggregateFile("data.yaml", [AggregateSection.Literal(text.ToString())]);
    }
}
