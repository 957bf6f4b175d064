using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Reads the names of files from a label. A name must end as files of its kind do.</summary>
public static class FileNames
{
    private const string SweepEnding = ".bin";

    private static readonly string[] PictureEndings = [".png", ".bmp", ".jpg", ".jpeg"];

    /// <summary>The name of a picture; that of another file of the session, such as labels.jsonl, is refused.</summary>
    public static string Picture(IJsonFields fields, string field)
    {
        string name = NotNull(fields).Text(field);
        return Array.Exists(PictureEndings, ending => name.EndsWith(ending, StringComparison.OrdinalIgnoreCase))
            ? name
            : throw fields.Refusal($"{field} must name a picture ({string.Join(", ", PictureEndings)}), not \"{name}\".");
    }

    /// <summary>The name of a file of points.</summary>
    public static string Sweep(IJsonFields fields, string field)
    {
        string name = NotNull(fields).Text(field);
        return name.EndsWith(SweepEnding, StringComparison.OrdinalIgnoreCase)
            ? name
            : throw fields.Refusal($"{field} of lidar must name points ({SweepEnding}), not \"{name}\".");
    }

    private static IJsonFields NotNull(IJsonFields fields) => fields ?? throw new ArgumentNullException(nameof(fields));
}
