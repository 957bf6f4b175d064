using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Scenes;
using Harvester.Geometry;

namespace Harvester.Capture.Spaces.Survey;

/// <summary>
/// Measures models one after the other: call <see cref="Step"/> once in every tick, from the game's own thread, until it is over. A model
/// that the folder knows as done is passed over. Nothing is thrown to the caller after construction, and whatever happens no model
/// is left standing.
/// </summary>
public sealed class SpaceSurvey : IDisposable
{
    /// <summary>Ticks in which a model must be loaded; ten seconds of a game of 60 ticks a second.</summary>
    private const int MostLoadingTicks = 600;

    /// <summary>Ticks from putting a model up until rays meet it.</summary>
    private const int SettlingTicks = 2;

    private readonly ISurveyStage _stage;
    private readonly SurveyFolder _folder;
    private readonly List<SurveyedModel> _models;
    private readonly int _raysPerTick;
    private readonly IEnumerator<bool> _run;
    private int? _standing;

    /// <summary>Makes a survey; nothing is asked of the game before the first step.</summary>
    /// <param name="stage">Where models are put up.</param>
    /// <param name="models">The models to measure.</param>
    /// <param name="folder">Where the rows go.</param>
    /// <param name="raysPerTick">Rays that a tick may cast; at least 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">Fewer than 1 ray.</exception>
    public SpaceSurvey(ISurveyStage stage, IEnumerable<SurveyedModel> models, SurveyFolder folder, int raysPerTick = 1_000)
    {
        _stage = stage ?? throw new ArgumentNullException(nameof(stage));
        _folder = folder ?? throw new ArgumentNullException(nameof(folder));
        _models = [.. models ?? throw new ArgumentNullException(nameof(models))];
        _raysPerTick = raysPerTick >= 1 ? raysPerTick : throw new ArgumentOutOfRangeException(nameof(raysPerTick), raysPerTick, "A tick needs at least one ray.");
        _run = Run().GetEnumerator();
    }

    /// <summary>Models of the list.</summary>
    public int Models => _models.Count;

    /// <summary>Models that are done, those of earlier surveys included.</summary>
    public int Done { get; private set; }

    /// <summary>Whether there is nothing more to do.</summary>
    public bool IsOver { get; private set; }

    /// <summary>One line that says why the survey ended before its time; null without a fault.</summary>
    public string? Fault { get; private set; }

    /// <summary>Does one tick's share. After the end it does nothing.</summary>
    public void Step()
    {
        if (IsOver)
        {
            return;
        }

        try
        {
            if (!_run.MoveNext())
            {
                End();
            }
        }
#pragma warning disable CA1031 // The game's script loop must not see an exception of ours, whatever its type.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            Fault = $"The survey stopped: {exception.Message}";
            End();
        }
    }

    /// <summary>Ends the survey and takes away what stands.</summary>
    public void Dispose() => End();

    private IEnumerable<bool> Run()
    {
        foreach (SurveyedModel model in _models)
        {
            if (!_folder.IsDone(model.Name))
            {
                foreach (bool tick in Measure(model))
                {
                    yield return tick;
                }
            }

            Done++;
        }
    }

    private IEnumerable<bool> Measure(SurveyedModel model)
    {
        ModelLoading loading = _stage.Load(model.Name);
        for (int ticks = 0; loading == ModelLoading.Loading && ticks < MostLoadingTicks; ticks++)
        {
            yield return true;
            loading = _stage.Load(model.Name);
        }

        StagedModel? put = loading == ModelLoading.Loaded ? _stage.PutUp(model.Name) : null;
        if (put is not { } staged)
        {
            _folder.Finish(model.Name, loading == ModelLoading.Missing ? "missing" : "refused", []);
            yield break;
        }

        _standing = staged.Handle;
        for (int ticks = 0; ticks < SettlingTicks; ticks++)
        {
            yield return true;
        }

        var probe = new StageProbe(_stage.Rays, staged);
        var faces = new FaceFinder(probe, staged);
        var heads = new HeadFinder(probe, staged);
        int rays = 0;
        foreach (bool ray in staged.Heads.Count > 0 ? heads.Run() : faces.Run())
        {
            if (++rays % _raysPerTick == 0)
            {
                yield return ray;
            }
        }

        TakeAway();
        SpaceOfInterest[] rows = [.. (staged.Heads.Count > 0 ? heads.Heads : faces.Faces).Select((space, face) => RowOf(model, space, face))];
        _folder.Finish(model.Name, rows.Length == 0 ? "noFace" : "measured", rows);
        yield return true;
    }

    private static SpaceOfInterest RowOf(SurveyedModel model, MeasuredSpace space, int face) => new(
        model.Name,
        ModelHash.Of(model.Name),
        model.Class,
        face == 0 || model.Class == ObjectClass.TrafficLight ? model.SignName : string.Empty,
        face == 0 ? model.MutcdCode : string.Empty,
        face,
        new Vector3D(space.Min.X, space.Max.Y, space.Max.Z),
        new Vector3D(space.Max.X, space.Min.Y, space.Min.Z),
        space.Facing,
        space.IsWholeModel ? Provenance.Derived : Provenance.Measured,
        space.IsWholeModel ? "rays found no post: the whole model" : "rays in the game");

    private void TakeAway()
    {
        if (_standing is { } entity)
        {
            _stage.TakeAway(entity);
            _standing = null;
        }
    }

    private void End()
    {
        IsOver = true;
        try
        {
            TakeAway();
        }
#pragma warning disable CA1031 // The first fault is the one to tell.
        catch (Exception exception)
#pragma warning restore CA1031
        {
            Fault ??= $"The survey stopped: {exception.Message}";
        }
    }
}
