using System.Globalization;
using System.Xml;

namespace Harvester.Play.Settings;

/// <summary>Settings of the game that change what its pictures show; null where the file does not have one.</summary>
public sealed record GraphicsSettings
{
    /// <summary>Maximum number of characters of a file.</summary>
    private const int MaxCharacters = 1024 * 1024;

    /// <summary>Motion Blur Strength, 0 to 1; 0 is off.</summary>
    public double? MotionBlur { get; private init; }

    /// <summary>In-Game Depth Of Field Effects.</summary>
    public bool? DepthOfField { get; private init; }

    /// <summary>MSAA, samples per pixel; 0 is off.</summary>
    public double? Msaa { get; private init; }

    /// <summary>TXAA, which mixes each picture with those before it.</summary>
    public bool? Txaa { get; private init; }

    /// <summary>Post FX: 0 Normal, 1 High, 2 Very High, 3 Ultra.</summary>
    public double? PostFx { get; private init; }

    /// <summary>Pause Game On Focus Loss.</summary>
    public bool? PausesWithoutFocus { get; private init; }

    /// <summary>The settings that harm pictures or labels, each with its value.</summary>
    public IEnumerable<string> Harmful
    {
        get
        {
            if (MotionBlur > 0)
            {
                yield return string.Format(CultureInfo.InvariantCulture, "Motion Blur Strength is {0}", MotionBlur);
            }

            if (DepthOfField == true)
            {
                yield return "In-Game Depth Of Field Effects is on";
            }

            if (Msaa > 0)
            {
                yield return string.Format(CultureInfo.InvariantCulture, "MSAA is {0}", Msaa);
            }

            if (Txaa == true)
            {
                yield return "TXAA is on";
            }

            if (PostFx > 0)
            {
                yield return string.Format(CultureInfo.InvariantCulture, "Post FX is above Normal ({0})", PostFx);
            }
        }
    }

    /// <summary>Reads settings.xml. Elements and values that are unknown are skipped.</summary>
    /// <param name="xml">The text of the file.</param>
    /// <exception cref="XmlException">It is not well-formed, has a document type or is too long.</exception>
    public static GraphicsSettings Parse(TextReader xml)
    {
        var options = new XmlReaderSettings
        {
            DtdProcessing = DtdProcessing.Prohibit,
            XmlResolver = null,
            MaxCharactersInDocument = MaxCharacters,
            IgnoreComments = true,
        };
        using XmlReader reader = XmlReader.Create(xml, options);
        var settings = new GraphicsSettings();
        while (reader.Read())
        {
            if (reader.NodeType == XmlNodeType.Element && reader.GetAttribute("value") is { } value)
            {
                settings = settings.With(reader.LocalName, value);
            }
        }

        return settings;
    }

    private GraphicsSettings With(string element, string value) =>
        element switch
        {
            "MotionBlurStrength" => this with { MotionBlur = Number(value) },
            "DoF" => this with { DepthOfField = Flag(value) },
            "MSAA" => this with { Msaa = Number(value) },
            "TXAA_Enabled" => this with { Txaa = Flag(value) },
            "PostFX" => this with { PostFx = Number(value) },
            "PauseOnFocusLoss" => this with { PausesWithoutFocus = Flag(value) },
            _ => this,
        };

    private static double? Number(string value) =>
        double.TryParse(value, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : null;

    private static bool? Flag(string value) =>
        value switch
        {
            "true" or "1" => true,
            "false" or "0" => false,
            _ => null,
        };
}
