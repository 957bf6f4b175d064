using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Sessions.Files;

namespace Harvester.Play.Features;

/// <summary>
/// Hides entities for coded masks, and shows them again whatever happens. What moves with an entity, such as the occupants of a vehicle, is
/// hidden and shown with it, unless it is announced itself, as a rider is. Before anything is hidden, the list of what may be hidden is on
/// disk, and it stays there until everything is shown. If the script ends in between, its next start shows what is on the list. Entities
/// that were hidden by someone else are left as they are.
/// </summary>
/// <param name="visibility">Shows and hides the entities of the game.</param>
/// <param name="path">The file of the list.</param>
/// <param name="messages">Says if the list cannot be written.</param>
/// <param name="isNeeded">Whether a feature may need entities hidden.</param>
public sealed class HiddenEntities(IShownEntities visibility, string path, PlayerMessages messages, Func<bool> isNeeded)
    : IVisibility,
        ILastingFeature
{
    private static readonly TimeSpan MaxWaitForDisk = TimeSpan.FromSeconds(2);
    private readonly HashSet<int> _hidden = [];
    private readonly Dictionary<int, int[]> _groups = [];
    private IReadOnlyCollection<int>? _announced;
    private Task _writing = Task.CompletedTask;
    private Task<string[]>? _reading;
    private bool _isRestored;

    /// <inheritdoc/>
    public string Name => "The hiding of objects";

    /// <inheritdoc/>
    public bool IsOn => _announced is not null;

    /// <inheritdoc/>
    public bool IsBusy => !_writing.IsCompleted || _reading is { IsCompleted: false };

    private bool IsWritten => Background.IsDone(nameof(_writing), () => _writing.IsCompleted);

    /// <inheritdoc/>
    public IReadOnlyCollection<int>? Announce(IReadOnlyCollection<int> entities)
    {
        if (!_isRestored || !IsWritten)
        {
            return null;
        }

        if (_announced is null)
        {
            _announced = [.. entities.Where(CanBeHidden)];
            FindGroups(_announced, [.. entities]);
            string text = string.Join("\n", new[] { visibility.Process }.Concat(_groups.Values.SelectMany(all => all).Select(Text))) + "\n";
            _writing = Task.Run(() => AtomicFile.Write(path, text));
            return null;
        }

        if (_writing.Exception?.InnerException is { } failure)
        {
            messages.Tell($"Masks come from rays, because the list of hidden objects cannot be written: {failure.Message}");
            _announced = null;
            _writing = Task.CompletedTask;
            return [];
        }

        return _announced;
    }

    /// <inheritdoc/>
    public void HideOnly(IReadOnlyCollection<int> entities)
    {
        if (_announced is not { } announced || !IsWritten)
        {
            throw new InvalidOperationException("Entities are announced before they are hidden.");
        }

        var wanted = new HashSet<int>(entities.Where(announced.Contains).SelectMany(entity => _groups[entity]));
        foreach (int entity in _groups.Values.SelectMany(group => group))
        {
            if (wanted.Contains(entity) != _hidden.Contains(entity) && visibility.Exists(entity))
            {
                // Noted first: a fault between the two calls leaves an entity on the list that is shown once too often, not one hidden.
                _hidden.Add(entity);
                visibility.Show(entity, !wanted.Contains(entity));
                if (!wanted.Contains(entity))
                {
                    _hidden.Remove(entity);
                }
            }
        }
    }

    /// <inheritdoc/>
    public void ShowAll()
    {
        if (_announced is null)
        {
            return;
        }

        foreach (int entity in _hidden.ToList())
        {
            if (visibility.Exists(entity))
            {
                visibility.Show(entity, true);
            }

            _hidden.Remove(entity);
        }

        _announced = null;
        _writing = _writing.ContinueWith(_ => File.Delete(path), TaskScheduler.Default);
    }

    /// <summary>
    /// Shows what an earlier run of the script has left hidden, once, and what the game refused to show when it was no longer needed.
    /// </summary>
    public void Tick()
    {
        if (_isRestored)
        {
            if (_announced is not null && !isNeeded())
            {
                ShowAll();
            }

            return;
        }

        _reading ??= Task.Run(() => File.Exists(path) ? File.ReadAllLines(path) : []);
        if (!Background.IsDone(nameof(_reading), () => _reading.IsCompleted))
        {
            return;
        }

        // Whatever the file holds, the script goes on; a damaged one names nothing.
        _isRestored = true;
        string[] lines = _reading.Status == TaskStatus.RanToCompletion ? _reading.Result : [];
        int shown = 0;
        if (lines.Length > 0 && lines[0] == visibility.Process)
        {
            foreach (string line in lines.Skip(1))
            {
                if (
                    int.TryParse(line, NumberStyles.Integer, CultureInfo.InvariantCulture, out int entity)
                    && visibility.Exists(entity)
                    && !visibility.IsShown(entity)
                )
                {
                    visibility.Show(entity, true);
                    shown++;
                }
            }
        }

        if (shown > 0)
        {
            messages.Tell($"{shown} objects that an earlier run had left hidden are shown again.");
        }

        if (lines.Length > 0)
        {
            _writing = Task.Run(() => File.Delete(path));
        }
    }

    /// <inheritdoc/>
    public void Stop() => ShowAll();

    /// <inheritdoc/>
    public void Finish()
    {
        ShowAll();
        _writing.ContinueWith(static _ => { }, TaskScheduler.Default).Wait(MaxWaitForDisk);
    }

    private bool CanBeHidden(int entity) => visibility.Exists(entity) && visibility.IsShown(entity);

    private void FindGroups(IReadOnlyCollection<int> announced, HashSet<int> alone)
    {
        _groups.Clear();
        ILookup<int, int> members = visibility.GroupsOf(announced);
        foreach (int entity in announced)
        {
            _groups[entity] = [entity, .. members[entity].Where(member => !alone.Contains(member) && CanBeHidden(member))];
        }
    }

    private static string Text(int entity) => entity.ToString(CultureInfo.InvariantCulture);
}
