using GTA.Math;
using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Tapes;

namespace Harvester.Mod;

/// <summary>How calls to the game are written on a tape.</summary>
internal static class TapedCall
{
    /// <summary>
    /// Whether a native is not recorded. The texts on the screen have paths and depend on the disk, and the number plate may be a name; the
    /// game answers none of these natives.
    /// </summary>
    public static bool IsLeftOut(Hash native) =>
        native
            is Hash.SET_TEXT_FONT
                or Hash.SET_TEXT_SCALE
                or Hash.SET_TEXT_COLOUR
                or Hash.SET_TEXT_OUTLINE
                or Hash.BEGIN_TEXT_COMMAND_DISPLAY_TEXT
                or Hash.ADD_TEXT_COMPONENT_SUBSTRING_PLAYER_NAME
                or Hash.END_TEXT_COMMAND_DISPLAY_TEXT
                or Hash.SET_VEHICLE_NUMBER_PLATE_TEXT;

    /// <summary>The target of a list of nearby entities.</summary>
    public static ulong TargetOf(EntityKind kind) =>
        kind switch
        {
            EntityKind.Vehicle => TapeLists.Vehicles,
            EntityKind.Ped => TapeLists.Peds,
            _ => TapeLists.Props,
        };

    /// <summary>What is asked of a list.</summary>
    public static TapeValue[] Asked(Vector3D centre, double radius, IReadOnlyList<int> models)
    {
        var asked = new List<TapeValue> { TapeValue.Of((float)centre.X, (float)centre.Y, (float)centre.Z), TapeValue.Of((float)radius) };
        foreach (int model in models)
        {
            asked.Add(TapeValue.Of(model));
        }

        return [.. asked];
    }

    /// <summary>A result of a native.</summary>
    public static TapeValue Recorded(object? result) =>
        result switch
        {
            bool value => TapeValue.Of(value),
            int value => TapeValue.Of(value),
            float value => TapeValue.Of(value),
            Vector3 value => TapeValue.Of(value.X, value.Y, value.Z),
            string or null => TapeValue.Of((string?)result),
            _ => throw new NotSupportedException($"A tape has no results of type {result.GetType()}."),
        };

    /// <summary>The result of a native that a tape has; null if the tape has another type.</summary>
    /// <param name="type">The type that the mod reads.</param>
    /// <param name="value">The value of the tape.</param>
    public static object? Result(Type type, TapeValue value) =>
        type == typeof(bool) && value.Kind is TapeValueKind.False or TapeValueKind.True ? value.Kind == TapeValueKind.True
        : type == typeof(int) && value.Kind == TapeValueKind.Whole ? value.Whole
        : type == typeof(float) && value.Kind == TapeValueKind.Real ? value.X
        : type == typeof(Vector3) && value.Kind == TapeValueKind.Vector ? new Vector3(value.X, value.Y, value.Z)
        : type == typeof(string) && value.Kind == TapeValueKind.Text ? value.Text
        : null;
}
