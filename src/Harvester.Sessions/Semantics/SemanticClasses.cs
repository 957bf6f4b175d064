using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Semantics;

/// <summary>The classes of class maps: their colours for display, and how they relate to the classes of objects.</summary>
public static class SemanticClasses
{
    private static readonly Dictionary<string, SemanticClass> ByName = Names();

    private static readonly (byte Red, byte Green, byte Blue)[] Colours =
    [
        (0, 0, 0),
        (128, 64, 128),
        (244, 35, 232),
        (255, 255, 255),
        (70, 70, 70),
        (107, 142, 35),
        (152, 251, 152),
        (70, 130, 180),
        (0, 170, 255),
        (153, 153, 153),
        (190, 153, 153),
        (0, 0, 142),
        (0, 0, 70),
        (0, 60, 100),
        (0, 0, 230),
        (119, 11, 32),
        (0, 0, 110),
        (220, 20, 60),
        (220, 220, 0),
        (250, 170, 30),
        (110, 110, 0),
        (255, 0, 0),
    ];

    /// <summary>The greatest value in a class map.</summary>
    public const int Greatest = (int)SemanticClass.Rider;

    /// <summary>The class of objects of a class.</summary>
    public static SemanticClass Of(ObjectClass kind) => (SemanticClass)((int)SemanticClass.Car + (int)kind);

    /// <summary>The objects that a class stands for; null for surfaces, the sky and <see cref="SemanticClass.None"/>.</summary>
    public static ObjectClass? ObjectOf(SemanticClass kind) =>
        kind is >= SemanticClass.Car and <= SemanticClass.Rider ? (ObjectClass)((int)kind - (int)SemanticClass.Car) : null;

    /// <summary>The colour of a class in pictures for display: red, green, blue.</summary>
    /// <exception cref="IndexOutOfRangeException">The value is no class.</exception>
    public static (byte Red, byte Green, byte Blue) ColourOf(SemanticClass kind) => Colours[(int)kind];

    /// <summary>The class with a name such as laneMarking; null if no class has it.</summary>
    public static SemanticClass? Named(string name) => ByName.TryGetValue(name, out SemanticClass found) ? found : null;

    private static Dictionary<string, SemanticClass> Names()
    {
        var names = new Dictionary<string, SemanticClass>(StringComparer.Ordinal);
        foreach (SemanticClass kind in (SemanticClass[])Enum.GetValues(typeof(SemanticClass)))
        {
            names[JsonName.Of(kind)] = kind;
        }

        return names;
    }
}
