using GTA.Math;
using GTA.Native;

namespace GTA.Hosting;

/// <summary>The one seam behind the stand-in: whoever plays the game implements it.</summary>
internal interface IGameHost
{
    /// <summary>Full path of the script's dll.</summary>
    string ScriptFile { get; }

    /// <summary>The game's build, as <see cref="GTA.GameVersion"/> counts them.</summary>
    int GameVersion { get; }

    /// <summary>A native function: its arguments are bools, ints, floats, strings and <see cref="OutputArgument"/>s, its result one of the former.</summary>
    object? Call(Hash native, object[] arguments);

    /// <summary>The handles of what lies within a radius of a point and, if models are named, has one of them.</summary>
    int[] HandlesNear(PoolKind pool, Vector3 position, float radius, int[] models);

    /// <summary>Shows a message to the player.</summary>
    void Notify(string message);
}
