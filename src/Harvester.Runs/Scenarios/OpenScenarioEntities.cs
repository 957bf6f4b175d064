using System.Xml.Linq;
using Harvester.Sessions.Scenarios;

namespace Harvester.Runs.Scenarios;

/// <summary>Writes actors as entities of OpenSCENARIO, and reads what they are.</summary>
internal static class OpenScenarioEntities
{
    /// <summary>Name of the property that has the model.</summary>
    private const string Model = "gtaModel";

    /// <summary>An entity; sizes are those of a usual car, because a model's are the game's.</summary>
    public static XElement Of(string name, ScenarioActorType type, string model)
    {
        XElement box = new(
            "BoundingBox",
            new XElement(
                "Center",
                OpenScenarioWriter.Number("x", 0),
                OpenScenarioWriter.Number("y", 0),
                OpenScenarioWriter.Number("z", 0.75)
            ),
            new XElement(
                "Dimensions",
                OpenScenarioWriter.Number("width", 1.9),
                OpenScenarioWriter.Number("length", 4.5),
                OpenScenarioWriter.Number("height", 1.5)
            )
        );
        XElement entity = type switch
        {
            ScenarioActorType.Pedestrian or ScenarioActorType.Animal => new XElement(
                "Pedestrian",
                new XAttribute("name", model),
                new XAttribute("pedestrianCategory", type == ScenarioActorType.Animal ? "animal" : "pedestrian"),
                OpenScenarioWriter.Number("mass", 75),
                box,
                PropertiesOf(model)
            ),
            ScenarioActorType.Object => new XElement(
                "MiscObject",
                new XAttribute("name", model),
                new XAttribute("miscObjectCategory", "obstacle"),
                OpenScenarioWriter.Number("mass", 50),
                box,
                PropertiesOf(model)
            ),
            _ => new XElement(
                "Vehicle",
                new XAttribute("name", model),
                new XAttribute("vehicleCategory", type == ScenarioActorType.Cyclist ? "bicycle" : "car"),
                box,
                new XElement(
                    "Performance",
                    OpenScenarioWriter.Number("maxSpeed", 70),
                    OpenScenarioWriter.Number("maxAcceleration", 10),
                    OpenScenarioWriter.Number("maxDeceleration", 10)
                ),
                new XElement("Axles", AxleOf("FrontAxle", 0.5, 2.7), AxleOf("RearAxle", 0, 0)),
                PropertiesOf(model)
            ),
        };
        return new XElement("ScenarioObject", new XAttribute("name", name), entity);
    }

    /// <summary>The type of an entity, and the class of models that its category names.</summary>
    public static (ScenarioActorType Type, string Model) TypeOf(XElement body) =>
        body.Name.LocalName switch
        {
            "Pedestrian" when body.Text("pedestrianCategory") == "animal" => (ScenarioActorType.Animal, "dog"),
            "Pedestrian" => (ScenarioActorType.Pedestrian, "pedestrian"),
            "MiscObject" => (ScenarioActorType.Object, "crate"),
            "Vehicle" => body.Text("vehicleCategory") switch
            {
                "bicycle" => (ScenarioActorType.Cyclist, "bicycle"),
                "motorbike" => (ScenarioActorType.Vehicle, "motorcycle"),
                "bus" => (ScenarioActorType.Vehicle, "bus"),
                "truck" or "semitrailer" => (ScenarioActorType.Vehicle, "truck"),
                "van" => (ScenarioActorType.Vehicle, "van"),
                "car" => (ScenarioActorType.Vehicle, "car"),
                var category => throw OpenScenarioXml.Wrong(body, $"the vehicleCategory {category} is not supported."),
            },
            _ => throw OpenScenarioXml.Unsupported(body),
        };

    /// <summary>The model that an entity written by <see cref="Of"/> has; null for that of its category.</summary>
    public static string? ModelOf(XElement body) =>
        body.Element("Properties")?.Elements("Property").FirstOrDefault(each => each.Attribute("name")?.Value == Model)?.Text("value");

    private static XElement PropertiesOf(string model) =>
        new("Properties", new XElement("Property", new XAttribute("name", Model), new XAttribute("value", model)));

    private static XElement AxleOf(string name, double steering, double x) =>
        new(
            name,
            OpenScenarioWriter.Number("maxSteering", steering),
            OpenScenarioWriter.Number("wheelDiameter", 0.65),
            OpenScenarioWriter.Number("trackWidth", 1.6),
            OpenScenarioWriter.Number("positionX", x),
            OpenScenarioWriter.Number("positionZ", 0.325)
        );
}
