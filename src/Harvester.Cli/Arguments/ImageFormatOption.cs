using System;
using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;

namespace Harvester.Cli.Arguments;

/// <summary>--image-format and --quality: how images are written.</summary>
internal static class ImageFormatOption
{
    private const string Forms = "png, bmp or jpg";

    public static Option<ImageFormat?> Format(string description) =>
        ValueParsers.Optional<ImageFormat>("--image-format", "F", description, Parse, Forms);

    public static Option<int?> Quality() => ValueParsers.Optional<int>(
        "--quality",
        "N",
        FormattableString.Invariant($"Quality of JPEG images, {JpegEncoder.MinQuality} to {JpegEncoder.MaxQuality} [default: {JpegEncoder.DefaultQuality}]"),
        ParseQuality,
        FormattableString.Invariant($"a whole number from {JpegEncoder.MinQuality} to {JpegEncoder.MaxQuality}"));

    /// <summary>The quality that was asked for, or the usual one.</summary>
    /// <exception cref="UsageException">It was asked for images that have none.</exception>
    public static int QualityOf(ParseResult parsed, Option<int?> quality, ImageFormat? format) => parsed.GetValue(quality) switch
    {
        null => JpegEncoder.DefaultQuality,
        { } asked when format == ImageFormat.Jpeg => asked,
        _ => throw new UsageException($"{quality.Name} has no effect without --image-format jpg."),
    };

    private static ImageFormat? Parse(string text) => text switch
    {
        "png" => ImageFormat.Png,
        "bmp" => ImageFormat.Bmp,
        "jpg" or "jpeg" => ImageFormat.Jpeg,
        _ => null,
    };

    private static int? ParseQuality(string text) =>
        int.TryParse(text, System.Globalization.NumberStyles.None, System.Globalization.CultureInfo.InvariantCulture, out int quality)
            && quality is >= JpegEncoder.MinQuality and <= JpegEncoder.MaxQuality ? quality : null;
}
