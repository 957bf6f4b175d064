using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Arguments;

/// <summary>Options whose values are parsed; the error for an invalid value shows the expected form and an example.</summary>
internal static class ValueParsers
{
    /// <summary>An option of three numbers, such as -75.3,-820.1,26.</summary>
    public static Option<Vector3D> Vector(string name, string form, string description) =>
        Parsed<Vector3D>(
            name,
            form,
            description,
            text => NumberText.ReadList(text, 3) is { } n ? new Vector3D(n[0], n[1], n[2]) : null,
            "three numbers, e.g. 10,-20.5,3"
        );

    /// <summary>An option of two numbers, such as 0,-1000.</summary>
    public static Option<Vector2D?> Point(string name, string form, string description) =>
        Optional<Vector2D>(
            name,
            form,
            description,
            text => NumberText.ReadList(text, 2) is { } n ? new Vector2D(n[0], n[1]) : null,
            "two numbers, e.g. 0,-1000"
        );

    /// <summary>An option of an image's size, such as 800x600.</summary>
    /// <param name="name">Name of the option.</param>
    /// <param name="description">Description for the help.</param>
    /// <param name="min">Smallest width and height, pixels.</param>
    /// <param name="maxSide">Largest width and height, pixels.</param>
    public static Option<ImageSize> Size(string name, string description, ImageSize min, int maxSide)
    {
        string allowed =
            min.Width == min.Height
                ? FormattableString.Invariant($"width and height in pixels, {min.Width} to {maxSide} each, e.g. 800x600")
                : FormattableString.Invariant($"width and height in pixels, {min.Width}x{min.Height} to {maxSide}x{maxSide}, e.g. 800x600");
        return Parsed(name, "WxH", description, Parse, allowed);

        ImageSize? Parse(string text) =>
            ParseSize(text) is { } size
            && size.Width >= min.Width
            && size.Height >= min.Height
            && Math.Max(size.Width, size.Height) <= maxSide
                ? size
                : null;
    }

    /// <summary>An option of a number within a range.</summary>
    public static Option<double> Number(string name, string form, string description, Func<double, bool> isAllowed, string allowed) =>
        Parsed(name, form, description, text => NumberText.Read(text) is { } value && isAllowed(value) ? value : (double?)null, allowed);

    /// <summary>An option of a whole number within a range.</summary>
    public static Option<int> Integer(string name, string form, string description, int min, int max)
    {
        string allowed = FormattableString.Invariant($"a whole number from {min} to {max}");
        return Parsed(name, form, description, Parse, allowed);

        int? Parse(string text) =>
            int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value) && value >= min && value <= max
                ? value
                : null;
    }

    /// <summary>An option whose value is the name of an enum's member, in any case.</summary>
    public static Option<T> Choice<T>(string name, string description)
        where T : struct, Enum => Parsed<T>(name, string.Join('|', JsonNames.All<T>()), description, ParseChoice<T>, Alternatives<T>());

    /// <summary>As <see cref="Choice"/>, for an option that may be left out.</summary>
    public static Option<T?> OptionalChoice<T>(string name, string description)
        where T : struct, Enum => Optional<T>(name, string.Join('|', JsonNames.All<T>()), description, ParseChoice<T>, Alternatives<T>());

    /// <summary>An option whose value is the name of one of several things, in any case; null if it is left out.</summary>
    public static Option<T?> OptionalOneOf<T>(string name, string description, IReadOnlyList<T> choices, Func<T, string> nameOf)
        where T : class
    {
        string[] names = [.. choices.Select(nameOf)];
        return new Option<T?>(name)
        {
            Description = description,
            HelpName = string.Join('|', names),
            CustomParser = result =>
            {
                string text = result.Tokens[0].Value;
                T? found = choices.FirstOrDefault(choice => nameOf(choice).Equals(text, StringComparison.OrdinalIgnoreCase));
                if (found is null)
                {
                    result.AddError($"{name} takes {Listed(names)}, not '{text}'.");
                }

                return found;
            },
        };
    }

    /// <summary>An option whose value a function parses; if it returns null, the error says what was expected.</summary>
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

    /// <summary>The value of an enum with a name, in any case; null for an unknown one.</summary>
    public static T? ParseChoice<T>(string text)
        where T : struct, Enum =>
        Enum.GetValues<T>().Where(value => JsonName.Of(value).Equals(text, StringComparison.OrdinalIgnoreCase)).Cast<T?>().FirstOrDefault();

    private static string Alternatives<T>()
        where T : struct, Enum => Listed([.. JsonNames.All<T>()]);

    /// <summary>Names as a list: one, two or three.</summary>
    public static string Listed(string[] names) => names.Length == 1 ? names[0] : $"{string.Join(", ", names[..^1])} or {names[^1]}";

    private static ImageSize? ParseSize(string text)
    {
        string[] sides = text.Split('x', 'X');
        return sides.Length == 2 && Side(sides[0]) is { } width && Side(sides[1]) is { } height ? new ImageSize(width, height) : null;
    }

    private static int? Side(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int side) && side is >= 1 and <= ushort.MaxValue
            ? side
            : null;
}
