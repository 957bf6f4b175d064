using System;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Linq;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;

namespace Harvester.Cli.Arguments;

/// <summary>Options whose values have a form of their own; a value of another form is refused with the form and an example.</summary>
internal static class ValueParsers
{
    /// <summary>An option of three numbers, as -75.3,-820.1,26.</summary>
    public static Option<Vector3D> Vector(string name, string form, string description) =>
        Parsed<Vector3D>(name, form, description, text =>
            Numbers(text, 3) is { } n ? new Vector3D(n[0], n[1], n[2]) : null, "three numbers, e.g. 10,-20.5,3");

    /// <summary>An option of two numbers, as 0,-1000.</summary>
    public static Option<Vector2D?> Point(string name, string form, string description) =>
        Optional<Vector2D>(name, form, description, text =>
            Numbers(text, 2) is { } n ? new Vector2D(n[0], n[1]) : null, "two numbers, e.g. 0,-1000");

    /// <summary>An option of an image's size, as 800x600.</summary>
    /// <param name="name">The option.</param>
    /// <param name="description">What it is.</param>
    /// <param name="least">The smallest width and height.</param>
    /// <param name="most">The largest width and height.</param>
    public static Option<ImageSize> Size(string name, string description, ImageSize least, int most)
    {
        string allowed = least.Width == least.Height
            ? FormattableString.Invariant($"width and height in pixels, {least.Width} to {most} each, e.g. 800x600")
            : FormattableString.Invariant($"width and height in pixels, {least.Width}x{least.Height} to {most}x{most}, e.g. 800x600");
        return Parsed(name, "WxH", description, Parse, allowed);

        ImageSize? Parse(string text) =>
            ParseSize(text) is { } size && size.Width >= least.Width && size.Height >= least.Height
                && Math.Max(size.Width, size.Height) <= most ? size : null;
    }

    /// <summary>An option of a number within a range.</summary>
    public static Option<double> Number(string name, string form, string description, Func<double, bool> isAllowed, string allowed) =>
        Parsed(name, form, description, text => Number(text) is { } value && isAllowed(value) ? value : (double?)null, allowed);

    /// <summary>An option of a whole number within a range.</summary>
    public static Option<int> Integer(string name, string form, string description, int least, int most)
    {
        string allowed = FormattableString.Invariant($"a whole number from {least} to {most}");
        return Parsed(name, form, description, Parse, allowed);

        int? Parse(string text) =>
            int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value) && value >= least
                && value <= most
                ? value
                : null;
    }

    /// <summary>A finite number in the invariant culture, or null.</summary>
    public static double? Number(string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && double.IsFinite(value) ? value : null;

    /// <summary>So many finite numbers with commas between them, or null.</summary>
    public static double[]? Numbers(string text, int count)
    {
        double?[] numbers = [.. text.Split(',').Select(part => Number(part.Trim()))];
        return numbers.Length == count && numbers.All(number => number is not null) ? [.. numbers.Select(number => number!.Value)] : null;
    }

    /// <summary>An option whose value a function reads; null from it is an error that says what was expected.</summary>
    public static Option<T> Parsed<T>(string name, string form, string description, Func<string, T?> parse, string expected)
        where T : struct
    {
        return new Option<T>(name)
        {
            Description = description,
            HelpName = form,
            CustomParser = result => Read(result, name, parse, expected) ?? default,
        };
    }

    /// <summary>As <see cref="Parsed"/>, for an option that may be left out.</summary>
    public static Option<T?> Optional<T>(string name, string form, string description, Func<string, T?> parse, string expected)
        where T : struct
    {
        return new Option<T?>(name)
        {
            Description = description,
            HelpName = form,
            CustomParser = result => Read(result, name, parse, expected),
        };
    }

    private static T? Read<T>(ArgumentResult result, string name, Func<string, T?> parse, string expected)
        where T : struct
    {
        string text = result.Tokens[0].Value;
        T? value = parse(text);
        if (value is null)
        {
            result.AddError($"{name} takes {expected}, not '{text}'.");
        }

        return value;
    }

    private static ImageSize? ParseSize(string text)
    {
        string[] sides = text.Split('x', 'X');
        return sides.Length == 2 && Side(sides[0]) is { } width && Side(sides[1]) is { } height ? new ImageSize(width, height) : null;
    }

    private static int? Side(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int side) && side is >= 1 and <= ushort.MaxValue ? side
            : null;
}
