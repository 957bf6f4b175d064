using System.Globalization;
using System.Xml.Linq;
using Harvester.Datasets.Roads.Sources;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Roads.Scene;

/// <summary>An object of a scene, with its attributes and references.</summary>
internal sealed class SceneObject
{
    private readonly RoadSource _source;
    private readonly XElement _element;
    private readonly Dictionary<string, string> _attributes = new(System.StringComparer.Ordinal);

    public SceneObject(RoadSource source, XElement element)
    {
        _source = source;
        _element = element;
        foreach (XElement attribute in element.Element("attributes")?.Elements("attribute") ?? [])
        {
            string name = attribute.Attribute("name")?.Value ?? throw RoadXml.Wrong(source, attribute, "an attribute has no name.");
            _attributes[name] =
                attribute.Attribute("value")?.Value ?? throw RoadXml.Wrong(source, attribute, $"the attribute {name} has no value.");
        }
    }

    /// <summary>The guids of the objects that it refers to.</summary>
    public IReadOnlyList<string> References =>
        [.. (_element.Element("references")?.Elements("ref") ?? []).Select(reference => reference.Attribute("guid")?.Value ?? "")];

    public string? Text(string name) => _attributes.GetValueOrDefault(name);

    public bool IsTrue(string name) =>
        Text(name) switch
        {
            null or "false" or "False" or "0" => false,
            "true" or "True" or "1" => true,
            _ => throw Wrong($"the attribute {name} must be true or false."),
        };

    public double? Number(string name) =>
        Text(name) is not { } text ? null
        : double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && double.IsFinite(value) ? value
        : throw Wrong($"the attribute {name} must be a finite number.");

    public int Whole(string name, int fallback, int min, int max) =>
        Text(name) is not { } text ? fallback
        : int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value) && value >= min && value <= max
            ? value
        : throw Wrong($"the attribute {name} must be a whole number from {min} to {max}.");

    public DatasetFormatException Wrong(string what) => RoadXml.Wrong(_source, _element, what);
}
