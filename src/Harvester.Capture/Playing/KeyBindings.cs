using System;
using System.Collections.Generic;

namespace Harvester.Capture.Playing;

/// <summary>Which key does what, as the settings say.</summary>
/// <typeparam name="TKey">The keys of the keyboard.</typeparam>
/// <param name="folder">The settings; told of keys that have two uses.</param>
/// <param name="features">Lets the features work.</param>
public sealed class KeyBindings<TKey>(ModFolder folder, FeatureSet features)
    where TKey : struct, Enum
{
    private readonly Dictionary<TKey, (IFeature Feature, Action Press)> _uses = [];

    /// <summary>Gives a key its use.</summary>
    /// <param name="name">Name of the setting under [Keys].</param>
    /// <param name="fallback">The key where the settings name none.</param>
    /// <param name="feature">What is used.</param>
    /// <param name="press">What it does.</param>
    public void Add(string name, TKey fallback, IFeature feature, Action press)
    {
        TKey key = folder.Settings.Choice("Keys", name, fallback, "a key, such as NumPad0, I or F9");
        if (_uses.ContainsKey(key))
        {
            folder.Complain($"the key {key} has two uses; the first is kept.");
            return;
        }

        _uses.Add(key, (feature, press));
    }

    /// <summary>Does what a key is for, if it has a use.</summary>
    public void Press(TKey key)
    {
        if (_uses.TryGetValue(key, out (IFeature Feature, Action Press) use))
        {
            features.Do(use.Feature, use.Press);
        }
    }
}
