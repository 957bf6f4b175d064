using System.Windows.Forms;

namespace Harvester.Mod.Tests;

/// <summary>The keys of the shipped settings do nothing else in the game.</summary>
public sealed class DefaultKeyTests
{
    /// <summary>
    /// Keys that the game's default bindings use on foot and in vehicles in story mode, by the public list of its controls. Not among them:
    /// keys of GTA Online alone (N to talk, Y and T to chat), of the Rockstar Editor alone (K, U) and of the phone's camera alone (L).
    /// </summary>
    private static readonly HashSet<Keys> StoryMode =
    [
        Keys.A,
        Keys.B,
        Keys.C,
        Keys.D,
        Keys.E,
        Keys.F,
        Keys.G,
        Keys.H,
        Keys.M,
        Keys.P,
        Keys.Q,
        Keys.R,
        Keys.S,
        Keys.V,
        Keys.W,
        Keys.X,
        Keys.Z,
        Keys.D1,
        Keys.D2,
        Keys.D3,
        Keys.D4,
        Keys.D5,
        Keys.D6,
        Keys.D7,
        Keys.D8,
        Keys.D9,
        Keys.F1,
        Keys.F2,
        Keys.F3,
        Keys.F5,
        Keys.F6,
        Keys.F7,
        Keys.F8,
        Keys.F9,
        Keys.F10,
        Keys.F11,
        Keys.NumPad4,
        Keys.NumPad5,
        Keys.NumPad6,
        Keys.NumPad7,
        Keys.NumPad8,
        Keys.NumPad9,
        Keys.Add,
        Keys.Subtract,
        Keys.Space,
        Keys.Tab,
        Keys.CapsLock,
        Keys.Enter,
        Keys.Back,
        Keys.Escape,
        Keys.Insert,
        Keys.Delete,
        Keys.Home,
        Keys.PageUp,
        Keys.PageDown,
        Keys.Left,
        Keys.Right,
        Keys.Up,
        Keys.Down,
    ];

    /// <summary>The console of ScriptHookVDotNet, and Steam's screenshot.</summary>
    private static readonly HashSet<Keys> OtherPrograms = [Keys.F4, Keys.F12];

    [Fact]
    public void Default_keys_are_free_in_story_mode()
    {
        Keys[] defaults = [.. ShippedKeys.All];

        Assert.Equal(defaults.Distinct(), defaults);
        Assert.Empty(defaults.Intersect(StoryMode));
        Assert.Empty(defaults.Intersect(OtherPrograms));
        Assert.All([Keys.NumPad0, Keys.I, Keys.O], key => Assert.Contains(key, defaults));
    }
}
