using System.Xml.Linq;
using Harvester.Sessions.Scenarios;

namespace Harvester.Runs.Scenarios;

/// <summary>Writes actors as entities of OpenSCENARIO.</summary>
internal static class OpenScenarioEntities
{
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
                new XElement("Properties")
            ),
            ScenarioActorType.Object => new XElement(
                "MiscObject",
                new XAttribute("name", model),
                new XAttribute("miscObjectCategory", "obstacle"),
                OpenScenarioWriter.Number("mass", 50),
                box,
                new XElement("Properties")
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
                new XElement("Properties")
            ),
        };
        return new XElement("ScenarioObject", new XAttribute("name", name), entity);
    }

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
