using Harvester.Sessions.Scenes;
using Harvester.Simulation.People;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>
/// People of different builds and clothes: the variants are the phases of a stride, then postures of standing and of sitting (<see
/// cref="PersonPoses"/>). As in the game, the origin is at the hips, about a metre above the ground.
/// </summary>
internal static class PedestrianModels
{
    private static readonly Rgb Fair = new(226, 182, 150);
    private static readonly Rgb Tan = new(176, 124, 90);
    private static readonly Rgb Dark = new(112, 76, 54);
    private static readonly Rgb Black = new(34, 30, 30);
    private static readonly Rgb Brown = new(84, 56, 36);
    private static readonly Rgb Blond = new(196, 160, 96);
    private static readonly Rgb Grey = new(168, 166, 162);

    /// <summary>The people, in the order of the models.</summary>
    public static IReadOnlyList<Person> People { get; } =
    [
        new("a_m_y_business_01", 1.84, 1, 1, 1.6, Outfit.Trousers, true, false, Fair, Brown, new(44, 50, 66), new(36, 40, 52), Black),
        new("a_f_y_business_01", 1.70, 0.9, 0.88, 1.5, Outfit.Skirt, true, true, Tan, Black, new(136, 40, 54), new(30, 30, 36), Black),
        new(
            "a_m_m_skater_01",
            1.78,
            1.15,
            1.05,
            1.25,
            Outfit.Shorts,
            false,
            false,
            Fair,
            Blond,
            new(198, 170, 60),
            new(62, 76, 104),
            new(214, 214, 210)
        ),
        new(
            "a_f_y_fitness_01",
            1.66,
            0.85,
            0.88,
            1.75,
            Outfit.Trousers,
            false,
            true,
            Fair,
            Brown,
            new(60, 150, 150),
            new(34, 34, 40),
            new(220, 90, 120)
        ),
        new(
            "a_m_y_downtown_01",
            1.88,
            1.05,
            1.08,
            1.4,
            Outfit.Trousers,
            false,
            false,
            Dark,
            Black,
            new(210, 210, 206),
            new(84, 70, 56),
            new(160, 60, 40)
        ),
        new(
            "a_f_m_tourist_01",
            1.62,
            1.3,
            0.95,
            1.05,
            Outfit.Shorts,
            false,
            true,
            Tan,
            Brown,
            new(230, 120, 96),
            new(190, 182, 160),
            new(200, 196, 188)
        ),
        new("a_m_o_genstreet_01", 1.73, 1.2, 0.98, 0.85, Outfit.Coat, true, false, Dark, Grey, new(82, 104, 82), new(96, 92, 84), Brown),
        new(
            "a_m_m_fatlatin_01",
            1.75,
            1.6,
            1.08,
            1.05,
            Outfit.Trousers,
            false,
            false,
            Tan,
            Black,
            new(150, 60, 60),
            new(52, 60, 84),
            Black
        ),
        new("a_f_o_genstreet_01", 1.58, 1.15, 0.88, 0.8, Outfit.Skirt, true, false, Fair, Grey, new(120, 104, 150), new(88, 80, 96), Brown),
        new("a_f_y_hipster_01", 1.73, 0.88, 0.9, 1.35, Outfit.Coat, true, true, Fair, Blond, new(176, 150, 110), new(48, 52, 70), Brown),
        new(
            "a_m_y_runner_01",
            1.80,
            0.92,
            1,
            1.9,
            Outfit.Shorts,
            false,
            false,
            Dark,
            Black,
            new(240, 110, 40),
            new(40, 44, 60),
            new(230, 240, 90)
        ),
        new(
            "s_m_y_construct_01",
            1.82,
            1.15,
            1.12,
            1.3,
            Outfit.Trousers,
            true,
            false,
            Tan,
            new(244, 200, 40),
            new(246, 150, 30),
            new(60, 70, 92),
            Brown
        ),
    ];

    public static IEnumerable<Model> All() => People.Select(Build);

    /// <summary>The model of a person.</summary>
    public static Model Build(Person person)
    {
        IReadOnlyList<BodyPose> poses = PersonPoses.Of(person);
        return Model.Of(person.Name, ObjectClass.Pedestrian, [.. poses.Select(pose => BodyMesher.MeshOf(person, pose))]) with
        {
            Skeletons = [.. poses.Select(pose => pose.Skeleton)],
            StrideMetres = new Gait(new Proportions(person.Height, person.Shoulders), person.Pace).StrideLength,
            Pace = person.Pace,
        };
    }
}
