using System.Collections.Generic;
using System.Linq;
using System.Text;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;

namespace Harvester.Datasets.Exports.Yolo;

/// <summary>What both kinds of Ultralytics datasets have in common: folders, numbers of the classes and data.yaml.</summary>
internal sealed class YoloFiles(ExportOptions options)
{
    public const int Decimals = 6;
    private const string TrainSplit = "train";
    private const string ValSplit = "val";

    private readonly List<ObjectClass> _classes = [.. options.ClassList];

    /// <summary>Writes a frame's files and says how many objects they have, a line each.</summary>
    public static int Write(ExportFrame frame, FrameOutput output, IReadOnlyCollection<string> lines)
    {
        output.Transfer($"images/{frame.Split}/{frame.Name}{frame.ImageExtension}", frame.ImagePath);
        output.Text($"labels/{frame.Split}/{frame.Name}.txt", string.Concat(lines.Select(line => line + "\n")));
        return lines.Count;
    }

    /// <summary>The number of a class: its place among the exported ones.</summary>
    public int NumberOf(ObjectClass kind) => _classes.IndexOf(kind);

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
        for (int i = 0; i < _classes.Count; i++)
        {
            text.Append("  ").Append(Numbers.Text(i)).Append(": ").Append(JsonName.Of(_classes[i])).Append('\n');
        }

        return new AggregateFile("data.yaml", [AggregateSection.Literal(text.ToString())]);
    }
}
