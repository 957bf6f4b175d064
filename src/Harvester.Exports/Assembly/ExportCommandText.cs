using System.Globalization;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Assembly;

/// <summary>The command line of an export, without the names of folders.</summary>
internal static class ExportCommandText
{
    /// <summary>The command line with all options that are not the default.</summary>
    public static string Of(DatasetFormat format, ExportOptions options) =>
        string.Join(' ', Words(format, options).Prepend("harvester export SESSION...").Append("--out DIR"));

    private static IEnumerable<string> Words(DatasetFormat format, ExportOptions options)
    {
        yield return "--format " + format.Name;
        if (options.Splits.Splits.Count > 1 || options.Splits.Splits[0].Name != SplitPlan.Everything.Splits[0].Name)
        {
            yield return "--split "
                + string.Join(
                    ',',
                    options.Splits.Splits.Select(split => $"{split.Name}:{split.ShareFraction.ToString(CultureInfo.InvariantCulture)}")
                );
            if (options.Splits.Seed != 0)
            {
                yield return "--seed " + Numbers.Text(options.Splits.Seed);
            }

            if (!format.KeepsSequences && options.Splits.BlockFrames is { } block)
            {
                yield return "--split-block " + Numbers.Text(block);
            }
        }

        foreach (string word in ObjectWords(format, options))
        {
            yield return word;
        }

        if (format.HasLaneSelection && options.Lanes != default)
        {
            yield return "--lanes " + JsonName.Of(options.Lanes);
        }

        if (options.ImageFormat is { } image)
        {
            yield return "--image-format "
                + image.Extension().TrimStart('.')
                + (image == ImageFormat.Jpeg ? " --quality " + Numbers.Text(options.JpegQuality) : "");
        }
    }

    private static IEnumerable<string> ObjectWords(DatasetFormat format, ExportOptions options)
    {
        if (format.HasObjects && options.ClassList.Count < Enum.GetValues<ObjectClass>().Length)
        {
            yield return "--classes " + string.Join(',', options.ClassList.Select(JsonName.Of));
        }

        if (options.Names.Count > 0)
        {
            yield return "--map "
                + Quoted(string.Join(',', options.Names.OrderBy(name => name.Key).Select(name => $"{JsonName.Of(name.Key)}={name.Value}")));
        }

        if (options.Subclasses != Subclasses.None)
        {
            yield return "--subclasses " + options.Subclasses.ToString().ToLowerInvariant().Replace(" ", "", StringComparison.Ordinal);
        }

        if (options.MinVisibleFraction > 0)
        {
            yield return "--min-visible " + options.MinVisibleFraction.ToString(CultureInfo.InvariantCulture);
        }

        if (format.HasParts && options.Parts is { } parts && parts != format.DefaultParts)
        {
            yield return "--parts " + JsonName.Of(parts);
        }

        if (format.HasBoxes && options.Boxes is { } boxes)
        {
            yield return "--boxes " + JsonName.Of(boxes);
        }

        if (format.HasSegmentations && options.Segmentation != default)
        {
            yield return "--segmentation " + JsonName.Of(options.Segmentation);
        }

        if (format.HasMap && options.RoadsName is { } roads)
        {
            yield return "--roads " + Quoted(roads);
        }
    }

    /// <summary>A word of a shell's command line, in quotes if it has characters that mean something to a shell.</summary>
    private static string Quoted(string word) =>
        word.All(c => char.IsAsciiLetterOrDigit(c) || c is '=' or ',' or '-' or '_' or '.')
            ? word
            : $"'{word.Replace("'", "'\\''", StringComparison.Ordinal)}'";
}
