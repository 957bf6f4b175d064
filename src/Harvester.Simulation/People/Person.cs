using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.People;

/// <summary>Build, clothes and pace of a person.</summary>
/// <param name="Name">The model's name in the game.</param>
/// <param name="Height">Metres.</param>
/// <param name="Girth">Width and depth of the trunk and limbs, relative to a slim adult's.</param>
/// <param name="Shoulders">Width of the shoulders, relative to an adult's mean.</param>
/// <param name="Pace">Usual walking speed, metres per second.</param>
/// <param name="Outfit">What the person wears below the waist.</param>
/// <param name="HasSleeves">Whether the sleeves are long.</param>
/// <param name="HasLongHair">Whether the hair covers the neck.</param>
/// <param name="Skin">Colour of head and hands.</param>
/// <param name="Hair">Colour of the hair.</param>
/// <param name="Top">Colour of shirt, jacket or coat.</param>
/// <param name="Bottom">Colour of trousers or skirt.</param>
/// <param name="Shoes">Colour of the shoes.</param>
internal sealed record Person(
    string Name,
    double Height,
    double Girth,
    double Shoulders,
    double Pace,
    Outfit Outfit,
    bool HasSleeves,
    bool HasLongHair,
    Rgb Skin,
    Rgb Hair,
    Rgb Top,
    Rgb Bottom,
    Rgb Shoes
);
