using System.CommandLine;
using Harvester.Runs.Faults;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;

namespace Harvester.Cli.Arguments;

/// <summary>--image-format and --quality.</summary>
internal static class ImageFormatOption
{
    private const string Forms = "png, bmp or jpg";

    private static readonly string QualityRange = FormattableString.Invariant($"{JpegEncoder.MinQuality} to {JpegEncoder.MaxQuality}");

    public static Option<ImageFormat?> Format(string description) =>
        ValueParsers.Optional<ImageFormat>("--image-format", "F", description, Parse, Forms);

    public static Option<int?> Quality() =>
        ValueParsers.Optional<int>(
            "--quality",
            "N",
            FormattableString.Invariant($"Quality of JPEG images, {QualityRange} [default: {JpegEncoder.DefaultQuality}]"),
            ParseQuality,
            $"a whole number from {QualityRange}"
        );

    /// <summary>The requested quality, or the default.</summary>
    /// <exception cref="UsageException">A quality was given, but the images are not JPEG.</exception>
    public static int QualityOf(ParseResult parsed, Option<int?> quality, ImageFormat? format) =>
        parsed.GetValue(quality) switch
        {
            null => JpegEncoder.DefaultQuality,
            { } requested when format == ImageFormat.Jpeg => requested,
            _ => throw new UsageException($"{quality.Name} has no effect without --image-format jpg."),
        };

    private static ImageFormat? Parse(string text) =>
        text switch
        {
            "png" => ImageFormat.Png,
            "bmp" => ImageFormat.Bmp,
            "jpg" or "jpeg" => ImageFormat.Jpeg,
            _ => null,
        };

    private static int? ParseQuality(string text) =>
        int.TryParse(text, System.Globalization.NumberStyles.None, System.Globalization.CultureInfo.InvariantCulture, out int quality)
        && quality is >= JpegEncoder.MinQuality and <= JpegEncoder.MaxQuality
            ? quality
            : null;
}
