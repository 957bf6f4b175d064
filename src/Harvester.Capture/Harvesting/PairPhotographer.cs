using Harvester.Capture.Faults;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Takes the further pictures of a moment while the game is frozen. First, objects are hidden under the sky of the moment, which shows
/// whether and how late the game hides them. Then the skies follow, by hour and weather. From picture to picture either the sky changes or
/// the hidden objects, so that what <see cref="SettledPicture"/> sees is the change that was asked for.
/// </summary>
internal sealed class PairPhotographer
{
    private readonly PairOptions _options;
    private readonly GamePorts _game;
    private readonly ISky _sky;
    private readonly IVisibility _visibility;
    private readonly PixelBufferPool _pool;
    private readonly BackgroundEncoder _encoder;
    private readonly SettledPicture _settled;
    private readonly SortedDictionary<PairDrop, int> _drops = [];
    private readonly List<PairPicture> _taken = [];
    private PixelBuffer? _shown;
    private PairDrop? _drop;
    private int _ticks;
    private int _hidingTicks;
    private int _asked;
    private bool _isActive;
    private bool _isAnnounced;

    /// <summary>Creates a photographer.</summary>
    /// <param name="options">What to take; it asks for pairs.</param>
    /// <param name="game">The game, whose sky can be set and whose objects can be hidden.</param>
    /// <param name="pool">Buffers for the pictures.</param>
    public PairPhotographer(HarvestOptions options, GamePorts game, PixelBufferPool pool)
    {
        (_options, _game, _pool) = (options.Pairs, game, pool);
        (_sky, _visibility) = (game.Sky!, game.Visibility!);
        _encoder = new BackgroundEncoder(new PictureEncoder(options.Format, options.JpegQuality), pool);
        _settled = new SettledPicture(options.MaxPictureLagTicks);
    }

    /// <summary>The pictures of the last moment.</summary>
    public IReadOnlyList<PairPicture> Taken => [.. _taken.OrderBy(picture => picture.Place)];

    /// <summary>How many pictures are missing, and why; null if none is.</summary>
    public CaptureFault? Warning =>
        _drops.Count == 0
            ? null
            : new CaptureFault(
                FaultCode.PairsMissing,
                $"{_drops.Values.Sum()} of {Counted.Of(_asked, "further picture")} of moments are missing: "
                    + string.Join(", ", _drops.Select(drop => $"{drop.Value} {JsonName.Of(drop.Key)}"))
                    + "."
            );

    /// <summary>Takes the pictures of a moment. <see cref="Release"/> must be called afterwards, whatever happens.</summary>
    /// <param name="draft">The labels of the moment.</param>
    /// <param name="picture">The picture of the frame.</param>
    public IEnumerable<WorkStep> Take(FrameDraft draft, PixelBuffer picture)
    {
        _isActive = true;
        _isAnnounced = false;
        _ticks = 0;
        _settled.Begin();
        _settled.Observe(picture);
        IReadOnlyList<HiddenVariant> variants = HiddenVariant.Of(draft, _options.Without);
        yield return WorkStep.Do(Hide(draft.Snapshot.Environment, variants, picture));
        yield return WorkStep.Do(ShowSkies(draft.Snapshot.Environment, variants));
        yield return WorkStep.Do(Restore());
        while (_options.TakesAllTicks && _ticks < AllTicks)
        {
            yield return Tick();
        }
    }

    /// <summary>Lets the time pass that the pictures of a moment take, for a moment of another shard.</summary>
    public IEnumerable<WorkStep> Pass() => Enumerable.Repeat(WorkStep.Tick, _options.TakesAllTicks ? AllTicks : 0);

    /// <summary>Gives the sky back, shows everything again and returns the buffers. Calling it again has no effect.</summary>
    public void Release()
    {
        ReturnShown();
        _taken.Clear();
        if (_isActive)
        {
            try
            {
                _visibility.ShowAll();
            }
            finally
            {
                _sky.Restore();
                _isActive = false;
            }
        }
    }

    /// <summary>Each picture, restoring sky and objects, and single ticks in between.</summary>
    private int AllTicks => (_options.Pictures + 3) * _options.MaxTicks;

    /// <summary>Takes the pictures without objects under the sky of the moment.</summary>
    private IEnumerable<WorkStep> Hide(EnvironmentState moment, IReadOnlyList<HiddenVariant> variants, PixelBuffer picture)
    {
        if (variants.Count == 0)
        {
            yield break;
        }

        IReadOnlyCollection<int>? hideable;
        while ((hideable = _visibility.Announce([.. variants.SelectMany(variant => variant.Handles).Distinct()])) is null)
        {
            yield return Tick();
        }

        _isAnnounced = hideable.Count > 0;
        yield return Tick();
        PixelBuffer again = _pool.Rent();
        try
        {
            var change = new BoxChange(picture, _game.Screen.Grab(again).Refusal is null ? again : picture);
            foreach (HiddenVariant variant in variants)
            {
                int begun = _ticks;
                yield return WorkStep.Do(Watch(() => Show(variant), 0));

                variant.IsHidden = variant.Handles.All(hideable.Contains) && _shown is not null && change.IsSeen(_shown, variant.Boxes);
                _drop ??= variant.IsHidden ? null : PairDrop.NotHidden;
                _hidingTicks = Math.Max(_hidingTicks, variant.IsHidden ? _ticks - begun : 0);
                yield return WorkStep.Do(Record(SkyCondition.OfMoment(moment), variant));
            }
        }
        finally
        {
            _pool.Return(again);
        }
    }

    /// <summary>Takes the pictures under all skies. Under every other one they are taken in the opposite order.</summary>
    private IEnumerable<WorkStep> ShowSkies(EnvironmentState moment, IReadOnlyList<HiddenVariant> variants)
    {
        HiddenVariant?[] order = [.. variants.Where(variant => variant.IsHidden).Reverse(), null];
        HiddenVariant[] others = [.. variants.Where(variant => !variant.IsHidden)];
        if (others.Length > 0 && _options.Conditions > 0)
        {
            // What could not be hidden was hidden last, perhaps too late to be seen.
            yield return WorkStep.Do(Watch(() => Show(order[0]), _hidingTicks));
        }

        foreach (SkyCondition condition in SkyCondition.AllOf(_options, moment))
        {
            for (int number = 0; number < order.Length; number++)
            {
                HiddenVariant? variant = order[number];
                Action change = number == 0 ? () => _sky.Set(condition.SetWeather, condition.SetTimeOfDay) : () => Show(variant);
                yield return WorkStep.Do(Watch(change, number == 0 ? 0 : _hidingTicks));
                yield return WorkStep.Do(Record(condition, variant));
            }

            foreach (HiddenVariant variant in others)
            {
                ReturnShown();
                _drop = PairDrop.NotHidden;
                yield return WorkStep.Do(Record(condition, variant));
            }

            Array.Reverse(order);
        }
    }

    /// <summary>Gives back the sky of the moment and all objects, and waits until the picture shows them.</summary>
    private IEnumerable<WorkStep> Restore()
    {
        if (_taken.Count == 0)
        {
            yield break;
        }

        yield return WorkStep.Do(
            Watch(
                () =>
                {
                    Show(null);
                    _sky.Restore();
                },
                _hidingTicks
            )
        );
    }

    private void Show(HiddenVariant? without)
    {
        if (_isAnnounced)
        {
            _visibility.HideOnly(without?.Handles ?? []);
        }
    }

    /// <summary>Asks for a change and waits until the picture has settled, which then is <see cref="_shown"/>.</summary>
    private IEnumerable<WorkStep> Watch(Action change, int minTicks)
    {
        ReturnShown();
        _drop = null;
        _settled.Begin();
        change();
        for (int ticks = 1; _shown is null && _drop is null; ticks++)
        {
            yield return Tick();
            PixelBuffer now = _pool.Rent();
            if (_game.Screen.Grab(now).Refusal is not null)
            {
                _drop = PairDrop.NoPicture;
            }
            else if (_settled.Observe(now) && ticks >= minTicks)
            {
                _shown = now;
                break;
            }
            else if (ticks >= _options.MaxTicks)
            {
                _drop = PairDrop.Unsettled;
            }

            _pool.Return(now);
        }
    }

    /// <summary>Adds the settled picture, or why there is none, to those of the moment.</summary>
    private IEnumerable<WorkStep> Record(SkyCondition condition, HiddenVariant? without)
    {
        while (_drop is null && !Background.IsDone(nameof(BackgroundEncoder), () => !_encoder.IsFull))
        {
            if (_options.TakesAllTicks)
            {
                _encoder.WaitForOldest();
            }
            else
            {
                yield return Tick();
            }
        }

        var picture = new PairPicture(
            without is null ? condition.Name : $"{condition.Name}-without-{without.Name}",
            condition.Weather,
            condition.TimeOfDay,
            without?.Ids ?? []
        )
        {
            Place = (condition.Number * (_options.Without.Count + 1)) + (without?.Number ?? 0),
        };
        _asked++;
        if (_drop is { } drop)
        {
            _drops[drop] = (_drops.TryGetValue(drop, out int count) ? count : 0) + 1;
            _taken.Add(picture with { Dropped = drop });
        }
        else
        {
            _taken.Add(picture with { Content = _encoder.Encode(_shown!) });
            _shown = null;
        }
    }

    private WorkStep Tick()
    {
        _ticks++;
        return WorkStep.Tick;
    }

    private void ReturnShown()
    {
        if (_shown is { } shown)
        {
            _shown = null;
            _pool.Return(shown);
        }
    }
}
