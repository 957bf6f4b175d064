namespace Harvester.Play.Features;

/// <summary>The actions of keys, as set in the settings file.</summary>
/// <typeparam name="TKey">The keys of the keyboard.</typeparam>
/// <param name="folder">The settings; receives complaints about keys with two actions.</param>
/// <param name="features">Runs the actions.</param>
public sealed class KeyBindings<TKey>(ModFolder folder, FeatureSet features)
    where TKey : struct, Enum
{
    private readonly Dictionary<TKey, (IFeature Feature, Action Press)> _uses = [];
    private readonly Dictionary<TKey, (IFeature Feature, Action Press)> _usesGoingDown = [];

    /// <summary>Assigns an action to a key; it runs on release.</summary>
    /// <param name="name">Name of the setting under [Keys].</param>
    /// <param name="fallback">The key if the settings name none.</param>
    /// <param name="feature">The feature of the action.</param>
    /// <param name="press">The action.</param>
    public void Add(string name, TKey fallback, IFeature feature, Action press)
    {
        TKey key = folder.Settings.Choice("Keys", name, fallback, "a key, such as NumPad0, I or F9");
        Add(_uses, key, feature, press);
    }

    /// <summary>Assigns an action to keys; it runs when one goes down.</summary>
    /// <param name="section">Section of the setting.</param>
    /// <param name="name">Name of the setting.</param>
    /// <param name="fallback">The keys if the settings name none.</param>
    /// <param name="feature">The feature of the action.</param>
    /// <param name="press">The action.</param>
    public void AddGoingDown(string section, string name, IReadOnlyList<TKey> fallback, IFeature feature, Action press)
    {
        foreach (TKey key in folder.Settings.Choices(section, name, fallback, "keys, separated by commas, such as W, A, Space or Left"))
        {
            Add(_usesGoingDown, key, feature, press);
        }
    }

    /// <summary>Whether a key has an action that runs on release.</summary>
    public bool HasPress(TKey key) => _uses.ContainsKey(key);

    /// <summary>Whether a key has an action that runs when it goes down.</summary>
    public bool HasGoingDown(TKey key) => _usesGoingDown.ContainsKey(key);

    /// <summary>Runs the action of a released key, if it has one.</summary>
    public void Press(TKey key) => Do(_uses, key);

    /// <summary>Runs the action of a key that goes down, if it has one.</summary>
    public void GoDown(TKey key) => Do(_usesGoingDown, key);

    private void Add(Dictionary<TKey, (IFeature Feature, Action Press)> uses, TKey key, IFeature feature, Action press)
    {
        if (_uses.ContainsKey(key) || _usesGoingDown.ContainsKey(key))
        {
            folder.Complain($"the key {key} has two uses; the first is kept.");
            return;
        }

        uses.Add(key, (feature, press));
    }

    private void Do(Dictionary<TKey, (IFeature Feature, Action Press)> uses, TKey key)
    {
        if (uses.TryGetValue(key, out (IFeature Feature, Action Press) use))
        {
            features.Do(use.Feature, use.Press);
        }
    }
}
