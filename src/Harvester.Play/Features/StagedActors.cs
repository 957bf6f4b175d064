using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>
/// The actors of scenarios in the game: models are streamed in over ticks, actors appear where the camera does not look, drive and walk by
/// the game's own tasks, and are removed whatever happens.
/// </summary>
public sealed class StagedActors : ILastingFeature, ITrialStage
{
    private const double LoadMilliseconds = 10_000;

    /// <summary>An actor waits this long for the camera to look elsewhere, then it appears in any case.</summary>
    private const double ViewMilliseconds = 2000;
    private const double ViewRadius = 4;

    private readonly IActorGame _game;
    private readonly IModels _models;
    private readonly IClock _clock;
    private readonly PlayerMessages _messages;
    private readonly SortedDictionary<int, Slot> _actors = [];
    private int _lastHandle;
    private ActorInGame? _ego;

    /// <summary>Creates the feature.</summary>
    /// <param name="game">The game's entities and tasks.</param>
    /// <param name="models">The game's models.</param>
    /// <param name="clock">Real time.</param>
    /// <param name="messages">Reports actors that cannot appear.</param>
    public StagedActors(IActorGame game, IModels models, IClock clock, PlayerMessages messages) =>
        (_game, _models, _clock, _messages) = (game, models, clock, messages);

    /// <inheritdoc/>
    public string Name => "The stage";

    /// <inheritdoc/>
    public bool IsOn => _actors.Count > 0 || _ego is not null;

    /// <inheritdoc/>
    public bool IsBusy => false;

    /// <inheritdoc/>
    public bool AreAllThere => _actors.Values.All(static slot => slot.IsLeaving || slot.InGame.Entity != 0);

    /// <inheritdoc/>
    public StageSpawn Spawn(StageActor actor)
    {
        if (actor is null)
        {
            throw new ArgumentNullException(nameof(actor));
        }

        string name = ActorModels.NameOf(actor);
        int model = ModelHash.Of(name);
        bool drives = actor.Kind is StageKind.Vehicle or StageKind.Cyclist;
        if (drives ? !_models.IsVehicle(model) : !_game.HasModel(model))
        {
            return StageSpawn.Refused($"The game has no model '{name}'.");
        }

        _actors.Add(++_lastHandle, new Slot(actor, model, new ActorInGame(_game, drives), _clock.Milliseconds));
        return StageSpawn.Of(_lastHandle);
    }

    /// <inheritdoc/>
    public void Follow(int handle, StageOrder order) => ActorOf(handle)?.Follow(order);

    /// <inheritdoc/>
    public void SetSpeed(int handle, double speed, double acceleration) => ActorOf(handle)?.SetSpeed(speed);

    /// <inheritdoc/>
    public void SetDoor(int handle, int side, bool isOpen)
    {
        if (ActorOf(handle) is { Entity: not 0 and var vehicle } && _game.Exists(vehicle))
        {
            _game.SetDoor(vehicle, side < 0 ? 0 : 1, isOpen);
        }
    }

    /// <inheritdoc/>
    public void SetIndicators(int handle, StageIndicators indicators)
    {
        if (ActorOf(handle) is { Entity: not 0 and var vehicle } && _game.Exists(vehicle))
        {
            _game.SetIndicators(
                vehicle,
                indicators is StageIndicators.Left or StageIndicators.Hazard,
                indicators is StageIndicators.Right or StageIndicators.Hazard
            );
        }
    }

    /// <inheritdoc/>
    public int EntityOf(int handle) => ActorOf(handle)?.Entity ?? 0;

    /// <inheritdoc/>
    public void Launch(int handle, double speed)
    {
        int vehicle = handle == 0 ? _game.PlayersVehicle : EntityOf(handle);
        if (vehicle != 0 && _game.Exists(vehicle) && (handle == 0 || _actors[handle].Actor.Kind is StageKind.Vehicle or StageKind.Cyclist))
        {
            _game.SetForwardSpeed(vehicle, speed);
        }
    }

    /// <inheritdoc/>
    public void Clear() => Stop();

    /// <inheritdoc/>
    public void Remove(int handle)
    {
        if (_actors.TryGetValue(handle, out Slot? slot))
        {
            slot.IsLeaving = true;
            Delete(slot);
            _actors.Remove(handle);
        }
    }

    /// <inheritdoc/>
    public StageState? StateOf(int handle)
    {
        if (!_actors.TryGetValue(handle, out Slot? slot) || slot.IsLeaving)
        {
            return null;
        }

        (Vector3D min, Vector3D max) = _models.DimensionsOf(slot.Model);
        bool isThere = slot.InGame.Entity != 0;
        if (isThere && !_game.Exists(slot.InGame.Entity))
        {
            return null;
        }

        Pose pose = isThere ? _game.PoseOf(slot.InGame.Entity) : new Pose(slot.Actor.Ground, Axes.FromHeading(slot.Actor.HeadingDegrees));
        Vector3D velocity = isThere ? _game.VelocityOf(slot.InGame.Entity) : Vector3D.Zero;
        return new StageState(pose, velocity, slot.InGame.IsAtEnd, (max.Y - min.Y) / 2, (max.X - min.X) / 2);
    }

    /// <inheritdoc/>
    public void DriveEgo(StageOrder order)
    {
        _ego = new ActorInGame(_game, isVehicle: true);
        _ego.Follow(order);
    }

    /// <inheritdoc/>
    public void Tick()
    {
        RemoveLeaving();
        if (_ego is not null)
        {
            (_ego.Ped, _ego.Entity) = (_game.Player, _game.PlayersVehicle);
            if (_ego.Entity != 0)
            {
                _ego.Tick();
            }
        }

        foreach (int handle in _actors.Keys.ToArray())
        {
            Slot slot = _actors[handle];
            if (slot.InGame.Entity != 0)
            {
                slot.InGame.Tick();
            }
            else if (!Appear(slot))
            {
                slot.IsLeaving = true;
                Remove(handle);
                _messages.Tell($"The game did not make the actor '{slot.Actor.Model}' of the scenario.");
            }
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        if (_ego is not null)
        {
            _ego = null;
            _game.ClearTasks(_game.Player);
        }

        foreach (Slot slot in _actors.Values)
        {
            slot.IsLeaving = true;
        }

        RemoveLeaving();
    }

    /// <inheritdoc/>
    public void Finish() => Stop();

    private void RemoveLeaving() => RemoveAll([.. _actors.Where(actor => actor.Value.IsLeaving).Select(actor => actor.Key)], 0);

    /// <summary>Removes actors, the others too if the game refuses one; that one is tried again in the next tick.</summary>
    private void RemoveAll(int[] handles, int from)
    {
        if (from == handles.Length)
        {
            return;
        }

        try
        {
            Remove(handles[from]);
        }
        finally
        {
            RemoveAll(handles, from + 1);
        }
    }

    /// <summary>Makes an actor as soon as it can appear.</summary>
    /// <returns>False if it cannot.</returns>
    private bool Appear(Slot slot)
    {
        double waited = _clock.Milliseconds - slot.SinceMilliseconds;
        if (!IsLoaded(slot))
        {
            return waited < LoadMilliseconds;
        }

        if (waited < ViewMilliseconds && _game.IsInView(slot.Actor.Ground, ViewRadius))
        {
            return true;
        }

        bool isMade = Make(slot);
        Release(slot);
        return isMade;
    }

    private bool Make(Slot slot)
    {
        (ActorInGame made, StageActor actor) = (slot.InGame, slot.Actor);
        switch (actor.Kind)
        {
            case StageKind.Object:
                made.Entity = _game.MakeThing(slot.Model, actor.Ground);
                return made.Entity != 0;
            case StageKind.Vehicle:
            case StageKind.Cyclist:
                made.Entity = _game.MakeVehicle(slot.Model, actor.Ground, actor.HeadingDegrees);
                made.Ped = made.Entity == 0 ? 0 : _game.MakeDriver(ModelHash.Of(ActorModels.Driver), made.Entity);
                break;
            default:
                made.Entity = _game.MakePed(slot.Model, actor.Ground, actor.HeadingDegrees);
                made.Ped = made.Entity;
                break;
        }

        if (made.Ped == 0)
        {
            return false;
        }

        _game.Calm(made.Ped);
        if (made.Entity != made.Ped)
        {
            _game.PlaceOnGround(made.Entity);
            _game.SetForwardSpeed(made.Entity, actor.Speed);
        }

        return true;
    }

    private bool IsLoaded(Slot slot)
    {
        slot.HoldsModels = true;
        bool isLoaded = _models.Load(slot.Model);
        return (slot.Actor.Kind is not (StageKind.Vehicle or StageKind.Cyclist) || _models.Load(ModelHash.Of(ActorModels.Driver)))
            && isLoaded;
    }

    /// <summary>Lets the game unload the models of an actor, unless another one still waits for them.</summary>
    private void Release(Slot slot)
    {
        if (!slot.HoldsModels)
        {
            return;
        }

        foreach (int model in new[] { slot.Model, ModelHash.Of(ActorModels.Driver) })
        {
            if (!_actors.Values.Any(other => other != slot && other.HoldsModels && (other.Model == model || model != slot.Model)))
            {
                _models.Release(model);
            }
        }

        slot.HoldsModels = false;
    }

    /// <summary>Deletes what an actor has in the game. What the game refuses to delete is tried again with the next call.</summary>
    private void Delete(Slot slot)
    {
        Release(slot);
        (int entity, int ped) = (slot.InGame.Entity, slot.InGame.Ped);
        if (ped != 0 && _game.Exists(ped))
        {
            _game.DeletePed(ped);
        }

        slot.InGame.Ped = 0;
        if (entity != 0 && entity != ped && _game.Exists(entity))
        {
            if (slot.Actor.Kind == StageKind.Object)
            {
                _game.DeleteThing(entity);
            }
            else
            {
                _game.DeleteVehicle(entity);
            }
        }
    }

    private ActorInGame? ActorOf(int handle) => _actors.TryGetValue(handle, out Slot? slot) && !slot.IsLeaving ? slot.InGame : null;

    private sealed class Slot(StageActor actor, int model, ActorInGame inGame, double sinceMilliseconds)
    {
        public StageActor Actor { get; } = actor;

        public int Model { get; } = model;

        public ActorInGame InGame { get; } = inGame;

        public double SinceMilliseconds { get; } = sinceMilliseconds;

        /// <summary>Whether models of it are requested.</summary>
        public bool HoldsModels { get; set; }

        /// <summary>Whether it is to be removed; the game may have refused that.</summary>
        public bool IsLeaving { get; set; }
    }
}
